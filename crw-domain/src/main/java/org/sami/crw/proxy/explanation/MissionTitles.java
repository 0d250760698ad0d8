package org.sami.crw.proxy.explanation;

import java.util.Optional;
import org.sami.spn.protocol.Ids;

/** What people call missions. */
@FunctionalInterface
public interface MissionTitles {
    /** Names no plan: missions are named by their numbers alone. */
    MissionTitles NONE = mission -> Optional.empty();

    /** The name of a mission, or the title of its plan where it has no name of its own; empty where it is not known. */
    Optional<String> title(long mission);

    /** Names a mission by its number and its name or plan, or the operator where there is none. */
    default String words(long mission) {
        return mission == Ids.NONE
                ? "the operator"
                : "mission " + mission
                        + title(mission).map(title -> ", " + title).orElse("");
    }
}
