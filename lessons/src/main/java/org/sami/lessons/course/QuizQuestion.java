package org.sami.lessons.course;

import com.fasterxml.jackson.annotation.JsonProperty;
import com.fasterxml.jackson.annotation.JsonSubTypes;
import com.fasterxml.jackson.annotation.JsonTypeInfo;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Objects;
import org.jspecify.annotations.Nullable;

/** What a quiz asks, what is right, and what is said of what is wrong. */
@JsonTypeInfo(use = JsonTypeInfo.Id.NAME, property = "type")
@JsonSubTypes({
    @JsonSubTypes.Type(value = QuizQuestion.One.class, name = "one"),
    @JsonSubTypes.Type(value = QuizQuestion.Several.class, name = "several"),
    @JsonSubTypes.Type(value = QuizQuestion.Mark.class, name = "mark"),
    @JsonSubTypes.Type(value = QuizQuestion.Tokens.class, name = "tokens"),
    @JsonSubTypes.Type(value = QuizQuestion.Amount.class, name = "number")
})
public sealed interface QuizQuestion {
    /**
     * A choice.
     *
     * @param right whether it is right
     * @param why why it is right or wrong; may be empty text where it is right
     */
    record Choice(@JsonProperty(required = true) String text, boolean right, String why) {
        public Choice {
            Objects.requireNonNull(text, "text");
            why = Absent.orEmpty(why);
        }
    }

    /** One of some choices. */
    record One(@JsonProperty(required = true) List<Choice> choices) implements QuizQuestion {
        public One {
            choices = List.copyOf(choices);
            long right = choices.stream().filter(Choice::right).count();
            if (choices.size() < 2 || choices.size() > 6 || right != 1) {
                throw new IllegalArgumentException("\"choices\" are 2 to 6, of which one is right; these are "
                        + choices.size() + ", of which " + right + " are right");
            }
        }
    }

    /** All that are right of some choices. */
    record Several(@JsonProperty(required = true) List<Choice> choices) implements QuizQuestion {
        public Several {
            choices = List.copyOf(choices);
            if (choices.size() < 2 || choices.size() > 6 || choices.stream().noneMatch(Choice::right)) {
                throw new IllegalArgumentException(
                        "\"choices\" are 2 to 6, of which at least one is right; these are " + choices.size());
            }
        }
    }

    /** What can be marked in a net. */
    enum Kind {
        PLACES,
        TRANSITIONS,
        EDGES,
        ELEMENTS;

        @Override
        public String toString() {
            return name().toLowerCase(Locale.ROOT);
        }
    }

    /**
     * Elements of the picture's net.
     *
     * @param of what can be marked
     * @param right ids of those that are to be marked
     * @param why why an element does not belong, by its id
     * @param missing why an element belongs, by its id
     * @param otherwise what is said of the others
     */
    record Mark(
            @JsonProperty(required = true) Kind of,
            @JsonProperty(required = true) List<String> right,
            Map<String, String> why,
            Map<String, String> missing,
            @JsonProperty(value = "else", required = true) String otherwise)
            implements QuizQuestion {
        public Mark {
            Objects.requireNonNull(of, "of");
            right = List.copyOf(right);
            why = words(why);
            missing = words(missing);
            Objects.requireNonNull(otherwise, "else");
        }
    }

    /**
     * Where tokens stand after something has happened to those of the picture.
     *
     * @param after what happens, in words
     * @param testCase the test case of the picture's plan in which it happens
     * @param steps after how many of its steps
     * @param why what is said of likely wrong answers
     * @param otherwise what is said of the others
     */
    record Tokens(
            @JsonProperty(required = true) String after,
            @JsonProperty(value = "case", required = true) String testCase,
            @JsonProperty(required = true) int steps,
            List<WrongTokens> why,
            @JsonProperty(value = "else", required = true) String otherwise)
            implements QuizQuestion {
        public Tokens {
            Objects.requireNonNull(after, "after");
            Objects.requireNonNull(testCase, "case");
            why = Absent.orNone(why);
            Objects.requireNonNull(otherwise, "else");
        }
    }

    /** A likely wrong answer, and why it is wrong. */
    record WrongTokens(
            @JsonProperty(required = true) List<TokensAt> tokens,
            @JsonProperty(required = true) String why) {
        public WrongTokens {
            tokens = List.copyOf(tokens);
            Objects.requireNonNull(why, "why");
        }
    }

    /**
     * A number.
     *
     * @param unit what it counts; empty text where it needs none
     * @param why why a number is wrong, by the number
     * @param otherwise what is said of the others
     */
    record Amount(
            @JsonProperty(required = true) int right,
            String unit,
            Map<String, String> why,
            @JsonProperty(value = "else", required = true) String otherwise)
            implements QuizQuestion {
        public Amount {
            unit = Absent.orEmpty(unit);
            why = words(why);
            Objects.requireNonNull(otherwise, "else");
        }
    }

    private static Map<String, String> words(@Nullable Map<String, String> given) {
        return given == null ? Map.of() : Collections.unmodifiableMap(new LinkedHashMap<>(given));
    }
}
