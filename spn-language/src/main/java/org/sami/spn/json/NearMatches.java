package org.sami.spn.json;

import java.util.Collection;
import java.util.List;
import java.util.stream.Stream;
import org.sami.spn.finding.Suggestions;
import org.sami.spn.vocabulary.Direction;
import org.sami.spn.vocabulary.EventType;
import org.sami.spn.vocabulary.Vocabulary;

/** Names of a vocabulary that may have been meant by a word that it does not have. */
public final class NearMatches {
    private NearMatches() {}

    /** The names or other names of at most three events that are spelt most alike, the nearest first. */
    public static List<String> ofEvents(Vocabulary vocabulary, String word) {
        return nearest(vocabulary.events().values().stream().flatMap(NearMatches::names), word);
    }

    /** The end of a sentence about a word that is no event of one side: which was probably meant, or nothing. */
    static String guess(Vocabulary vocabulary, Direction side, String word) {
        return Suggestions.meant(
                vocabulary.events().values().stream()
                        .filter(event -> event.direction() == side)
                        .flatMap(NearMatches::names)
                        .toList(),
                word);
    }

    /** The names or other names of at most three markups that are spelt most alike, the nearest first. */
    public static List<String> ofMarkups(Vocabulary vocabulary, String word) {
        return nearest(
                vocabulary.markups().values().stream()
                        .flatMap(markup -> Stream.concat(Stream.of(markup.name()), markup.aliases().stream())),
                word);
    }

    /** The end of a sentence about a word that is none of some names: which may have been meant, or which there are. */
    static String meant(Collection<String> names, String word) {
        String meant = Suggestions.meant(names, word);
        if (!meant.isEmpty()) {
            return meant;
        }
        return names.isEmpty() ? "; there are none" : "; there are " + String.join(", ", names);
    }

    private static Stream<String> names(EventType event) {
        return Stream.concat(Stream.of(event.name()), event.aliases().stream());
    }

    private static List<String> nearest(Stream<String> names, String word) {
        return Suggestions.alike(names.toList(), word);
    }
}
