package org.sami.crw.gui.map;

import java.util.Collection;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Pattern;

/** Finds the boats that a sentence names: their names as words of their own, written as the fleet has them. */
final class BoatsInText {
    private static final String NO_PART_OF_A_NAME = "[\\p{L}\\p{N}_-]";

    private BoatsInText() {}

    /**
     * Those that are named, in the order of their names.
     *
     * @param boats those that it can name
     */
    static Set<String> of(String text, Collection<String> boats) {
        Set<String> named = new TreeSet<>();
        for (String boat : boats) {
            String word = "(?<!" + NO_PART_OF_A_NAME + ")" + Pattern.quote(boat) + "(?!" + NO_PART_OF_A_NAME + ")";
            if (Pattern.compile(word).matcher(text).find()) {
                named.add(boat);
            }
        }
        return named;
    }
}
