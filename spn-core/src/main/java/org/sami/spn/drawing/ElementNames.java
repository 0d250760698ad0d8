package org.sami.spn.drawing;

import java.util.Objects;
import java.util.Optional;
import java.util.stream.Stream;
import org.sami.spn.model.InputEventSpec;
import org.sami.spn.model.OutputEventSpec;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;
import org.sami.spn.model.SubMissionSpec;
import org.sami.spn.model.Transition;
import org.sami.spn.vocabulary.Vocabulary;

/** What the elements of a plan are called in sentences: never by their ids, which only files speak of. */
public final class ElementNames {
    private final Plan plan;
    private final Vocabulary vocabulary;

    /** The names of a plan's elements. */
    public ElementNames(Plan plan, Vocabulary vocabulary) {
        this.plan = Objects.requireNonNull(plan, "plan");
        this.vocabulary = Objects.requireNonNull(vocabulary, "vocabulary");
    }

    /**
     * A vertex by its name, or what it does; an edge by its two vertices; an event or sub-mission with its vertex. Empty where the plan has no
     * such element.
     */
    public Optional<String> of(String id) {
        return Stream.of(
                        plan.places().stream().flatMap(place -> at(place, id)),
                        plan.transitions().stream().flatMap(transition -> at(transition, id)),
                        plan.inEdges().stream()
                                .filter(edge -> edge.id().equals(id))
                                .map(edge -> vertex(edge.place()) + " → " + vertex(edge.transition())),
                        plan.outEdges().stream()
                                .filter(edge -> edge.id().equals(id))
                                .map(edge -> vertex(edge.transition()) + " → " + vertex(edge.place())))
                .flatMap(each -> each)
                .findFirst();
    }

    private Stream<String> at(Place place, String id) {
        if (place.id().equals(id)) {
            return Stream.of(of(place, vocabulary));
        }
        return Stream.concat(
                place.outputs().stream()
                        .filter(event -> event.id().equals(id))
                        .map(event -> at(VertexWords.label(event.type(), vocabulary), place.name())),
                place.subMissions().stream()
                        .filter(sub -> sub.id().equals(id))
                        .map(sub -> at("sub-mission " + sub.plan(), place.name())));
    }

    private Stream<String> at(Transition transition, String id) {
        if (transition.id().equals(id)) {
            return Stream.of(of(transition, vocabulary));
        }
        return transition.inputs().stream()
                .filter(event -> event.id().equals(id))
                .map(event -> at(VertexWords.label(event, vocabulary), transition.name()));
    }

    private static String at(String event, String vertex) {
        return vertex.isBlank() ? event : event + " at " + vertex;
    }

    private String vertex(String id) {
        return plan.place(id)
                .map(place -> of(place, vocabulary))
                .or(() -> plan.transition(id).map(transition -> of(transition, vocabulary)))
                .orElse("nothing");
    }

    /** A place by its name, or its first event or sub-mission where the author gave none. */
    public static String of(Place place, Vocabulary vocabulary) {
        return called(place, vocabulary)
                .orElse(place.start() ? "unnamed start" : place.end() ? "unnamed end" : "unnamed place");
    }

    /** A transition by its name, or its first event where the author gave none. */
    public static String of(Transition transition, Vocabulary vocabulary) {
        return called(transition, vocabulary).orElse("unnamed transition");
    }

    /** What a place is called; empty where it has neither a name nor an event nor a sub-mission. */
    static Optional<String> called(Place place, Vocabulary vocabulary) {
        return name(place.name())
                .or(() -> place.outputs().stream()
                        .findFirst()
                        .map(OutputEventSpec::type)
                        .map(type -> VertexWords.label(type, vocabulary)))
                .or(() -> place.subMissions().stream()
                        .findFirst()
                        .map(SubMissionSpec::plan)
                        .map(sub -> "sub-mission " + sub));
    }

    /** What a transition is called; empty where it has neither a name nor an event. */
    static Optional<String> called(Transition transition, Vocabulary vocabulary) {
        Optional<InputEventSpec> first = transition.inputs().stream().findFirst();
        return name(transition.name()).or(() -> first.map(event -> VertexWords.label(event, vocabulary)));
    }

    private static Optional<String> name(String name) {
        return name.isBlank() ? Optional.empty() : Optional.of(name);
    }
}
