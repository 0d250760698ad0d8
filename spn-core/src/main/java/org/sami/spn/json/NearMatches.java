package org.sami.spn.json;

import java.util.Collection;
import java.util.Comparator;
import java.util.List;
import java.util.stream.Stream;
import org.sami.spn.vocabulary.Direction;
import org.sami.spn.vocabulary.EventType;
import org.sami.spn.vocabulary.Vocabulary;

/** Names of a vocabulary that may have been meant by a word that it does not have. */
public final class NearMatches {
    private static final int MOST = 3;

    private NearMatches() {}

    /** The names or other names of at most three events that are spelt most alike, the nearest first. */
    public static List<String> ofEvents(Vocabulary vocabulary, String word) {
        return nearest(vocabulary.events().values().stream().flatMap(NearMatches::names), word);
    }

    /** The same among the events of one side. */
    static List<String> ofEvents(Vocabulary vocabulary, Direction side, String word) {
        return nearest(
                vocabulary.events().values().stream()
                        .filter(event -> event.direction() == side)
                        .flatMap(NearMatches::names),
                word);
    }

    /** The names or other names of at most three markups that are spelt most alike, the nearest first. */
    public static List<String> ofMarkups(Vocabulary vocabulary, String word) {
        return nearest(
                vocabulary.markups().values().stream()
                        .flatMap(markup -> Stream.concat(Stream.of(markup.name()), markup.aliases().stream())),
                word);
    }

    /** At most three of some names that are spelt most like a word, the nearest first. */
    static List<String> alike(Collection<String> names, String word) {
        return nearest(names.stream(), word);
    }

    /** The end of a sentence about a word that is none of some names: which may have been meant, or which there are. */
    static String meant(Collection<String> names, String word) {
        List<String> alike = nearest(names.stream(), word);
        if (!alike.isEmpty()) {
            return "; is " + String.join(" or ", alike) + " meant?";
        }
        return names.isEmpty() ? "; there are none" : "; there are " + String.join(", ", names);
    }

    private static Stream<String> names(EventType event) {
        return Stream.concat(Stream.of(event.name()), event.aliases().stream());
    }

    private static List<String> nearest(Stream<String> names, String word) {
        return names.filter(name -> Spelling.alike(name, word))
                .sorted(Comparator.comparingInt(name -> Spelling.distance(name, word)))
                .limit(MOST)
                .toList();
    }
}
