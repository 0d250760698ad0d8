package org.sami.spn.finding;

import java.util.Collection;
import java.util.Comparator;
import java.util.List;

/** Names that may have been meant by a word that is none of them. */
public final class Suggestions {
    private static final int MOST = 3;

    private Suggestions() {}

    /** At most three of some names that are spelt most like a word, the nearest first. */
    public static List<String> alike(Collection<String> names, String word) {
        return names.stream()
                .distinct()
                .filter(name -> Spelling.alike(name, word))
                .sorted(Comparator.comparingInt(name -> Spelling.distance(name, word)))
                .limit(MOST)
                .toList();
    }

    /** The end of a sentence about a word that is none of some names: which was probably meant, or nothing. */
    public static String meant(Collection<String> names, String word) {
        List<String> alike = alike(names, word);
        return alike.isEmpty() ? "" : "; is " + String.join(" or ", alike) + " meant?";
    }
}
