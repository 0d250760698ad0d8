package org.sami.ui.command;

import java.util.Optional;

/** Says which commands a window has for its person, by their ids. */
public interface CommandPolicy {
    /** Every command is there. */
    CommandPolicy ALL = new CommandPolicy() {};

    /** Whether a command is there at all. */
    default boolean shows(String id) {
        return true;
    }

    /** Why a command is shown and cannot be run; empty where nothing is against it. */
    default Optional<String> whyLocked(String id) {
        return Optional.empty();
    }
}
