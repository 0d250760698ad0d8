package org.sami.crw.console;

import java.util.List;
import java.util.Objects;
import org.sami.spn.value.TextNumbers;

/** The words behind a command's name, taken one after another; what is missing or is no number is a {@link ConsoleFault}. */
final class Arguments {
    private final String usage;
    private final List<String> words;
    private int next;

    Arguments(String usage, List<String> words) {
        this.usage = Objects.requireNonNull(usage, "usage");
        this.words = List.copyOf(words);
    }

    boolean hasNext() {
        return next < words.size();
    }

    /** The next word, without taking it; empty text after the last one. */
    String peek() {
        return hasNext() ? words.get(next) : "";
    }

    /**
     * Takes the next word.
     *
     * @param what it is, for the fault where there is none
     */
    String next(String what) {
        if (!hasNext()) {
            throw new ConsoleFault("which " + what + "? usage: " + usage);
        }
        return words.get(next++);
    }

    /** Takes the next word, which is a whole number. */
    long number(String what) {
        String word = next(what);
        return TextNumbers.whole(word, Long.MIN_VALUE, Long.MAX_VALUE)
                .orElseThrow(() -> new ConsoleFault("a " + what + " is a whole number, not '" + word + "'"));
    }

    /** Takes the next word, which is a number. */
    double real(String what) {
        String word = next(what);
        return TextNumbers.real(word)
                .orElseThrow(() -> new ConsoleFault("a " + what + " is a number, not '" + word + "'"));
    }

    /** Takes all words that are left. */
    List<String> rest() {
        List<String> rest = words.subList(next, words.size());
        next = words.size();
        return rest;
    }

    /** No word is left over. */
    void end() {
        if (hasNext()) {
            throw new ConsoleFault("'" + peek() + "' is too much; usage: " + usage);
        }
    }
}
