package org.sami.lessons.course;

import java.util.List;

/**
 * What is said of an answer.
 *
 * @param right whether it is right
 * @param words why not, a sentence each; where it is right, what is so
 */
public record Grade(boolean right, List<String> words) {
    public Grade {
        words = List.copyOf(words);
    }
}
