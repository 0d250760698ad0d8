package org.sami.crw.proxy;

import java.util.Optional;

/** What people call the plans of missions. */
@FunctionalInterface
public interface MissionTitles {
    /** Names no plan: missions are told by their numbers alone. */
    MissionTitles NONE = mission -> Optional.empty();

    /** The title of a mission's plan; empty where it is not known. */
    Optional<String> title(long mission);
}
