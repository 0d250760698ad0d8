package org.sami.crw.cli.plan;

import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.Collection;
import java.util.List;
import java.util.function.Function;
import java.util.stream.Stream;
import org.sami.spn.json.NearMatches;
import org.sami.spn.json.VocabularyWriter;
import org.sami.spn.vocabulary.EventType;
import org.sami.spn.vocabulary.MarkupType;
import org.sami.spn.vocabulary.Vocabulary;

/**
 * One kind of entries of a vocabulary, and how such an entry is printed.
 *
 * @param kind what an entry is called
 * @param names the name of an entry, and its other names
 * @param alike the names that are nearest to a word
 * @param text an entry as a paragraph
 * @param node an entry as JSON
 */
record VocabularyEntries<T>(
        String kind,
        Collection<T> all,
        Function<T, Stream<String>> names,
        Function<String, List<String>> alike,
        Function<T, String> text,
        Function<T, ObjectNode> node) {
    static VocabularyEntries<EventType> events(Vocabulary vocabulary) {
        return new VocabularyEntries<>(
                "event",
                vocabulary.events().values(),
                event -> Stream.concat(Stream.of(event.name()), event.aliases().stream()),
                word -> NearMatches.ofEvents(vocabulary, word),
                new VocabularyText(vocabulary)::of,
                new VocabularyWriter(vocabulary)::event);
    }

    static VocabularyEntries<MarkupType> markups(Vocabulary vocabulary) {
        return new VocabularyEntries<>(
                "markup",
                vocabulary.markups().values(),
                markup -> Stream.concat(Stream.of(markup.name()), markup.aliases().stream()),
                word -> NearMatches.ofMarkups(vocabulary, word),
                new VocabularyText(vocabulary)::of,
                new VocabularyWriter(vocabulary)::markup);
    }
}
