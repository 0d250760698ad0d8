package org.sami.dreamm.context;

import java.util.List;
import java.util.Objects;

/**
 * Something that the author is asked at the top of the window, while everything else goes on.
 *
 * @param id stable, in kebab case; a question takes the place of an open one of the same id
 * @param text one or two sentences
 * @param choices from left to right; Enter takes the first
 * @param dismissed what happens when the author leaves without a choice
 */
public record AuthorQuestion(String id, String text, List<Choice> choices, Runnable dismissed) {
    /**
     * An answer.
     *
     * @param id stable, in kebab case; the name of its button
     */
    public record Choice(String id, String label, Runnable chosen) {
        public Choice {
            Objects.requireNonNull(id, "id");
            Objects.requireNonNull(label, "label");
            Objects.requireNonNull(chosen, "chosen");
        }
    }

    public AuthorQuestion {
        Objects.requireNonNull(id, "id");
        Objects.requireNonNull(text, "text");
        choices = List.copyOf(choices);
        Objects.requireNonNull(dismissed, "dismissed");
    }
}
