package org.sami.dreamm.help;

import java.util.List;
import java.util.Objects;

/**
 * The help about one subject.
 *
 * @param title what people call it
 * @param kind what sort of thing it is, in one line
 * @param text what it does, in sentences
 * @param details its parts, each with its description
 */
public record HelpTopic(String title, String kind, String text, List<Detail> details) {
    public HelpTopic {
        Objects.requireNonNull(title, "title");
        Objects.requireNonNull(kind, "kind");
        Objects.requireNonNull(text, "text");
        details = List.copyOf(details);
    }

    /** A part of it. */
    public record Detail(String name, String text) {
        public Detail {
            Objects.requireNonNull(name, "name");
            Objects.requireNonNull(text, "text");
        }
    }
}
