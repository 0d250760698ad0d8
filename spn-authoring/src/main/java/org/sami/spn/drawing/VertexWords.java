package org.sami.spn.drawing;

import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.stream.Collectors;
import org.sami.spn.model.MarkupSpec;
import org.sami.spn.model.Place;
import org.sami.spn.model.Transition;
import org.sami.spn.model.WaitFor;
import org.sami.spn.naming.ElementNames;
import org.sami.spn.vocabulary.Vocabulary;

/**
 * What is written at a vertex.
 *
 * @param name what people call it; empty text where it has no name, but where events are folded what it does
 * @param events a line for each output event, sub-mission or input event
 */
public record VertexWords(String name, List<String> events) {
    private static final String DISABLED = "disabled for trying";

    public VertexWords {
        Objects.requireNonNull(name, "name");
        events = List.copyOf(events);
    }

    /** A place with its output events and sub-missions. */
    public static VertexWords of(Place place, Vocabulary vocabulary) {
        return of(place, vocabulary, NetDetail.READER);
    }

    static VertexWords of(Place place, Vocabulary vocabulary, NetDetail detail) {
        List<String> lines = new ArrayList<>();
        if (place.disabled()) {
            lines.add(DISABLED);
        }
        if (detail.events()) {
            place.outputs().forEach(output -> {
                lines.add("→ " + vocabulary.title(output.type()));
                addMarkups(output.markups(), detail, lines);
            });
            place.subMissions()
                    .forEach(sub -> lines.add((sub.shared() ? "shared sub-mission " : "sub-mission ") + sub.plan()));
        }
        return new VertexWords(
                detail.events()
                        ? place.name()
                        : ElementNames.called(place, vocabulary).orElse(""),
                lines);
    }

    /** A transition with its input events. */
    public static VertexWords of(Transition transition, Vocabulary vocabulary) {
        return of(transition, vocabulary, NetDetail.READER);
    }

    static VertexWords of(Transition transition, Vocabulary vocabulary, NetDetail detail) {
        List<String> lines = new ArrayList<>();
        if (transition.disabled()) {
            lines.add(DISABLED);
        }
        if (detail.events()) {
            transition.inputs().forEach(input -> {
                lines.add("← " + ElementNames.waitedFor(input, vocabulary));
                addMarkups(input.markups(), detail, lines);
            });
            if (transition.waitFor() == WaitFor.ALL) {
                lines.add("waits for all");
            }
        }
        return new VertexWords(
                detail.events()
                        ? transition.name()
                        : ElementNames.called(transition, vocabulary).orElse(""),
                lines);
    }

    private static void addMarkups(List<MarkupSpec> markups, NetDetail detail, List<String> lines) {
        if (detail.markups() && !markups.isEmpty()) {
            lines.add("with " + markups.stream().map(MarkupSpec::type).collect(Collectors.joining(", ")));
        }
    }
}
