package org.sami.spn.wizard;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import org.sami.spn.model.OutputEventSpec;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Transition;
import org.sami.spn.sequence.AuthoringLibrary;
import org.sami.spn.sequence.Sequence;
import org.sami.spn.vocabulary.EventRole;
import org.sami.spn.vocabulary.EventType;
import org.sami.spn.vocabulary.Vocabulary;

/** What can come next at a vertex: the answers that a place's events can cause, and what usually follows a transition's. */
public final class NextEvents {
    private final Vocabulary vocabulary;
    private final AuthoringLibrary library;

    /** The answers of a domain. */
    public NextEvents(Vocabulary vocabulary, AuthoringLibrary library) {
        this.vocabulary = Objects.requireNonNull(vocabulary, "vocabulary");
        this.library = Objects.requireNonNull(library, "library");
    }

    /**
     * One event that can come next.
     *
     * @param cause what brings it about, in words
     * @param drawn whether a transition behind the place, or a place behind the transition, has it already
     */
    public record Next(EventType event, String cause, boolean drawn) {
        public Next {
            Objects.requireNonNull(event, "event");
            Objects.requireNonNull(cause, "cause");
        }
    }

    /** The events that can come next at a vertex; those that are not drawn yet come first. */
    public List<Next> at(Plan plan, String vertex) {
        Map<String, Next> found = new LinkedHashMap<>();
        plan.place(vertex).ifPresent(place -> afterPlace(plan, place, found));
        plan.transition(vertex).ifPresent(transition -> afterTransition(plan, transition, found));
        List<Next> ordered =
                new ArrayList<>(found.values().stream().filter(n -> !n.drawn()).toList());
        found.values().stream().filter(Next::drawn).forEach(ordered::add);
        return ordered;
    }

    private void afterPlace(Plan plan, Place place, Map<String, Next> found) {
        List<String> awaited = plan.inEdges().stream()
                .filter(e -> e.place().equals(place.id()))
                .flatMap(e -> plan.transition(e.transition()).stream())
                .flatMap(t -> t.inputs().stream().map(i -> i.type()))
                .toList();
        for (OutputEventSpec output : place.outputs()) {
            vocabulary
                    .event(output.type())
                    .ifPresent(asked ->
                            asked.answers().forEach(answer -> put(answer, "answers " + asked.label(), awaited, found)));
        }
        if (!place.subMissions().isEmpty()) {
            for (EventRole role : List.of(EventRole.CHECK_RETURN, EventRole.SUB_MISSION_ABORTED)) {
                vocabulary
                        .eventWithRole(role)
                        .ifPresent(e -> put(e.name(), "comes of the sub-mission", awaited, found));
            }
        }
    }

    private void afterTransition(Plan plan, Transition transition, Map<String, Next> found) {
        List<String> sent = plan.outEdgesOf(transition.id()).stream()
                .flatMap(e -> plan.place(e.place()).stream())
                .flatMap(p -> p.outputs().stream().map(OutputEventSpec::type))
                .toList();
        transition
                .inputs()
                .forEach(input -> vocabulary
                        .event(input.type())
                        .ifPresent(received -> library.ofInput(received.name())
                                .map(Sequence.OfInput::outputs)
                                .orElse(List.of())
                                .forEach(output -> put(output, "usually follows " + received.label(), sent, found))));
    }

    private void put(String event, String cause, List<String> drawn, Map<String, Next> found) {
        Optional<EventType> type = vocabulary.event(event);
        type.ifPresent(t -> found.putIfAbsent(t.name(), new Next(t, cause, drawn.contains(t.name()))));
    }
}
