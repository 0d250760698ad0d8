package org.sami.spn.drawing;

import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import org.sami.spn.model.InputEventSpec;
import org.sami.spn.model.Place;
import org.sami.spn.model.Transition;
import org.sami.spn.model.WaitFor;
import org.sami.spn.value.TextValue;
import org.sami.spn.vocabulary.EventType;
import org.sami.spn.vocabulary.Vocabulary;

/**
 * What is written at a vertex.
 *
 * @param name what people call it; empty text where it has no name
 * @param events a line for each output event, sub-mission or input event
 */
public record VertexWords(String name, List<String> events) {
    public VertexWords {
        Objects.requireNonNull(name, "name");
        events = List.copyOf(events);
    }

    /** A place with its output events and sub-missions. */
    public static VertexWords of(Place place, Vocabulary vocabulary) {
        List<String> lines = new ArrayList<>();
        place.outputs().forEach(output -> lines.add("→ " + label(output.type(), vocabulary)));
        place.subMissions()
                .forEach(sub -> lines.add((sub.shared() ? "shared sub-mission " : "sub-mission ") + sub.plan()));
        return new VertexWords(place.name(), lines);
    }

    /** A transition with its input events. */
    public static VertexWords of(Transition transition, Vocabulary vocabulary) {
        List<String> lines = new ArrayList<>();
        transition.inputs().forEach(input -> lines.add("← " + label(input, vocabulary)));
        if (transition.waitFor() == WaitFor.ALL) {
            lines.add("waits for all");
        }
        return new VertexWords(transition.name(), lines);
    }

    private static String label(InputEventSpec input, Vocabulary vocabulary) {
        StringBuilder text = new StringBuilder(label(input.type(), vocabulary));
        input.fields().values().stream()
                .filter(TextValue.class::isInstance)
                .map(value -> ((TextValue) value).value())
                .forEach(value -> text.append(": ").append(value));
        return text.toString();
    }

    private static String label(String type, Vocabulary vocabulary) {
        return vocabulary
                .event(type)
                .map(EventType::label)
                .filter(label -> !label.isEmpty())
                .orElse(type);
    }
}
