package org.sami.spn.json;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Collectors;
import org.sami.spn.finding.Suggestions;

/** The words that stand for enum constants in files: {@code AT_LEAST} is {@code at-least}. */
final class Words {
    private Words() {}

    static String of(Enum<?> constant) {
        return constant.name().toLowerCase(Locale.ROOT).replace('_', '-');
    }

    static <E extends Enum<E>> Optional<E> parse(Class<E> type, String word) {
        return Arrays.stream(type.getEnumConstants())
                .filter(c -> of(c).equals(word))
                .findFirst();
    }

    /** The end of a sentence about a word that stands for no constant: which there are, and which was probably meant. */
    static <E extends Enum<E>> String noneOf(Class<E> type, String word) {
        List<String> all = Arrays.stream(type.getEnumConstants()).map(Words::of).toList();
        return " is none of: " + String.join(", ", all) + Suggestions.meant(all, word);
    }

    static <E extends Enum<E>> String all(Class<E> type) {
        return Arrays.stream(type.getEnumConstants()).map(Words::of).collect(Collectors.joining(", "));
    }
}
