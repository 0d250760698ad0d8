package org.sami.spn.naming;

import java.util.Objects;
import java.util.Optional;
import java.util.stream.Stream;
import org.sami.spn.model.InputEventSpec;
import org.sami.spn.model.OutputEventSpec;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;
import org.sami.spn.model.SubMissionSpec;
import org.sami.spn.model.Transition;
import org.sami.spn.value.TextValue;
import org.sami.spn.vocabulary.Vocabulary;

/**
 * What the elements of a plan are called: by the name that the author gave, else by what they do, in the titles of the vocabulary, else by
 * their kind and their number in the plan. Never by their ids, of which only files speak.
 */
public final class ElementNames {
    private final Plan plan;
    private final Vocabulary vocabulary;

    /** The names of a plan's elements. */
    public ElementNames(Plan plan, Vocabulary vocabulary) {
        this.plan = Objects.requireNonNull(plan, "plan");
        this.vocabulary = Objects.requireNonNull(vocabulary, "vocabulary");
    }

    /** An element's name by its id; the vertices of an edge, an event or sub-mission with its vertex. Empty where the plan has no such element. */
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
            return Stream.of(of(place));
        }
        return Stream.concat(
                place.outputs().stream()
                        .filter(event -> event.id().equals(id))
                        .map(event -> at(vocabulary.title(event.type()), place.name())),
                place.subMissions().stream()
                        .filter(sub -> sub.id().equals(id))
                        .map(sub -> at("sub-mission " + sub.plan(), place.name())));
    }

    private Stream<String> at(Transition transition, String id) {
        if (transition.id().equals(id)) {
            return Stream.of(of(transition));
        }
        return transition.inputs().stream()
                .filter(event -> event.id().equals(id))
                .map(event -> at(waitedFor(event, vocabulary), transition.name()));
    }

    private static String at(String event, String vertex) {
        return vertex.isBlank() || vertex.equals(event) ? event : event + " at " + vertex;
    }

    private String vertex(String id) {
        return plan.place(id)
                .map(this::of)
                .or(() -> plan.transition(id).map(this::of))
                .orElse("nothing");
    }

    /** A place, such as {@code Go}, {@code Proxy Execute Path} or {@code place 3}. */
    public String of(Place place) {
        return called(place, vocabulary).orElseGet(() -> numbered(place));
    }

    /** A transition, such as {@code Arrived}, {@code Proxy Path Completed} or {@code transition 2}. */
    public String of(Transition transition) {
        return called(transition, vocabulary).orElseGet(() -> numbered(transition));
    }

    /** A place with its kind, after an article: {@code place "Go"}, {@code place of Proxy Execute Path}, {@code place 3}. */
    public String withKind(Place place) {
        return quoted("place", place.name())
                .or(() -> called(place, vocabulary).map(does -> "place of " + does))
                .orElseGet(() -> numbered(place));
    }

    /** A transition with its kind, after an article: {@code transition "Arrived"}, {@code transition of Proxy Path Completed}, {@code transition 2}. */
    public String withKind(Transition transition) {
        return quoted("transition", transition.name())
                .or(() -> called(transition, vocabulary).map(does -> "transition of " + does))
                .orElseGet(() -> numbered(transition));
    }

    /** A place in a sentence, without an article before it: {@code "Go"}, {@code the place of Proxy Execute Path}, {@code place 3}. */
    public String inSentence(Place place) {
        return inSentence(place.name(), called(place, vocabulary), "place").orElseGet(() -> numbered(place));
    }

    /** A transition in a sentence, without an article before it: {@code "Arrived"}, {@code the transition of Proxy Path Completed}, {@code transition 2}. */
    public String inSentence(Transition transition) {
        return inSentence(transition.name(), called(transition, vocabulary), "transition")
                .orElseGet(() -> numbered(transition));
    }

    private static Optional<String> inSentence(String name, Optional<String> called, String kind) {
        return given(name)
                .map(known -> "\"" + known + "\"")
                .or(() -> called.map(does -> "the " + kind + " of " + does));
    }

    private static Optional<String> quoted(String kind, String name) {
        return given(name).map(known -> kind + " \"" + known + "\"");
    }

    private String numbered(Place place) {
        return "place" + number(plan.places().stream().map(Place::id).toList().indexOf(place.id()));
    }

    private String numbered(Transition transition) {
        return "transition"
                + number(
                        plan.transitions().stream().map(Transition::id).toList().indexOf(transition.id()));
    }

    /** Its number as people count; of a vertex that another version of the plan has, none. */
    private static String number(int index) {
        return index < 0 ? "" : " " + (index + 1);
    }

    /** What a place is called; empty where it has neither a name nor an event nor a sub-mission. */
    public static Optional<String> called(Place place, Vocabulary vocabulary) {
        return given(place.name())
                .or(() -> place.outputs().stream()
                        .findFirst()
                        .map(OutputEventSpec::type)
                        .map(vocabulary::title))
                .or(() -> place.subMissions().stream()
                        .findFirst()
                        .map(SubMissionSpec::plan)
                        .map(sub -> "sub-mission " + sub));
    }

    /** What a transition is called; empty where it has neither a name nor an event. */
    public static Optional<String> called(Transition transition, Vocabulary vocabulary) {
        Optional<InputEventSpec> first = transition.inputs().stream().findFirst();
        return given(transition.name()).or(() -> first.map(event -> waitedFor(event, vocabulary)));
    }

    private static Optional<String> given(String name) {
        return name.isBlank() ? Optional.empty() : Optional.of(name);
    }

    /** What a transition waits for: the title of the event's type, and the texts that it must have, such as the name of an interrupt. */
    public static String waitedFor(InputEventSpec input, Vocabulary vocabulary) {
        StringBuilder text = new StringBuilder(vocabulary.title(input.type()));
        input.fields().values().stream()
                .filter(TextValue.class::isInstance)
                .map(value -> ((TextValue) value).value())
                .forEach(value -> text.append(": ").append(value));
        return text.toString();
    }
}
