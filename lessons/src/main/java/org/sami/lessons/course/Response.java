package org.sami.lessons.course;

import java.util.List;
import java.util.Set;

/** What a learner answers to a question: the form that the question has. */
public sealed interface Response {
    /** A choice, by its index in the file, from 0. */
    record Choice(int index) implements Response {}

    /** Choices, by their indices in the file, from 0. */
    record Choices(Set<Integer> indices) implements Response {
        public Choices {
            indices = Set.copyOf(indices);
        }
    }

    /** Marked elements, by their ids. */
    record Marks(Set<String> ids) implements Response {
        public Marks {
            ids = Set.copyOf(ids);
        }
    }

    /** Tokens in places; places that are not named are empty. */
    record Tokens(List<TokensAt> tokens) implements Response {
        public Tokens {
            tokens = List.copyOf(tokens);
        }
    }

    /** A number. */
    record Amount(int number) implements Response {}
}
