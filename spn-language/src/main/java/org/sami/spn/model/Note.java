package org.sami.spn.model;

import java.util.Objects;
import java.util.Optional;

/**
 * What an author noted about a plan. It means nothing at run time.
 *
 * @param at its left upper corner on the drawing, in drawing units at scale 1; empty where it belongs to the plan as a whole
 */
public record Note(String text, Optional<LayoutPoint> at) {
    public Note {
        Objects.requireNonNull(text, "text");
        Objects.requireNonNull(at, "at");
    }

    /** A note about the plan as a whole. */
    public static Note of(String text) {
        return new Note(text, Optional.empty());
    }

    /** The same note with another text. */
    public Note withText(String text) {
        return new Note(text, at);
    }

    /** The same note elsewhere. */
    public Note withAt(Optional<LayoutPoint> at) {
        return new Note(text, at);
    }
}
