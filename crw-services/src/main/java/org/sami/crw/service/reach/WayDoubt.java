package org.sami.crw.service.reach;

import java.util.Objects;
import java.util.Optional;

/**
 * What is wrong with a way.
 *
 * @param words a clause that names the boat, such as "boat1 is to go 48 km from where it is"
 */
public record WayDoubt(Kind kind, String words) {
    /** What a doubt is about. */
    public enum Kind {
        /** A point lies far away, or on land. */
        PLACE,
        /** The way is longer than the charge lasts. */
        CHARGE,
        /** The boat has come back from it twice for a new battery, and may go without coming home first. */
        NO_HEADWAY,
        /** The same, and its charge does not last for the way back. */
        ONE_WAY
    }

    public WayDoubt {
        Objects.requireNonNull(kind, "kind");
        Objects.requireNonNull(words, "words");
    }

    /** The same with what else is wrong with the way: both are read before either is answered. */
    public WayDoubt and(Optional<WayDoubt> other) {
        return other.map(more -> new WayDoubt(kind, words + "; " + more.words()))
                .orElse(this);
    }
}
