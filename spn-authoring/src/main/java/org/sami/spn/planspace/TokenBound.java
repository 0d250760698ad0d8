package org.sami.spn.planspace;

import java.util.List;
import java.util.Objects;
import java.util.OptionalInt;

/**
 * How many tokens of one kind can be in a place of a plan at once.
 *
 * @param most so many and no more; empty where no number is known to bound them
 * @param of how many there are in all; 0 where that is not known before a run
 * @param reason why there are no more, as the end of a sentence
 * @param limitedBy ids of the other places of the plan whose tokens, with these, are a constant sum; none where the reason is another one
 */
public record TokenBound(Kind kind, OptionalInt most, int of, String reason, List<String> limitedBy) {
    /** Kinds of tokens. */
    public enum Kind {
        ROBOT("robot", "robots"),
        TASK("task", "tasks"),
        GENERIC("generic token", "generic tokens");

        private final String one;
        private final String several;

        Kind(String one, String several) {
            this.one = one;
            this.several = several;
        }

        String word(int count) {
            return count == 1 ? one : several;
        }
    }

    public TokenBound {
        Objects.requireNonNull(kind, "kind");
        Objects.requireNonNull(most, "most");
        Objects.requireNonNull(reason, "reason");
        limitedBy = List.copyOf(limitedBy);
    }

    /** For people: {@code at most 2 of 3 robots}, {@code no task}, {@code any number of generic tokens}. */
    public String words() {
        if (most.isEmpty()) {
            return "any number of " + kind.word(2);
        }
        int count = most.getAsInt();
        if (count == 0) {
            return "no " + kind.word(1);
        }
        return "at most " + count + (of > 0 ? " of " + of + " " + kind.word(of) : " " + kind.word(count));
    }
}
