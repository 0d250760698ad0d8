package org.sami.dreamm.start;

import java.util.Objects;
import java.util.Optional;

/**
 * Whether a window is opened with the course.
 *
 * @param wanted whether it is
 * @param learner whose progress is kept; empty = who learned last, else the user of this machine
 */
public record LearnOptions(boolean wanted, Optional<String> learner) {
    /** Without the course. */
    public static final LearnOptions NONE = new LearnOptions(false, Optional.empty());

    public LearnOptions {
        Objects.requireNonNull(learner, "learner");
    }
}
