package org.sami.spn.analysis;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;
import java.util.stream.Collectors;
import org.sami.spn.model.InEdge;
import org.sami.spn.model.InputEventSpec;
import org.sami.spn.model.OutEdge;
import org.sami.spn.model.OutputEventSpec;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.model.SubMissionSpec;
import org.sami.spn.model.Transition;
import org.sami.spn.vocabulary.EventType;
import org.sami.spn.vocabulary.Vocabulary;

/** A plan with what surrounds it, and the questions that checks ask about neighbours and places in the document. */
final class PlanContext {
    private final Project project;
    private final Vocabulary vocabulary;
    private final Plan plan;
    private final String pointer;
    private final List<PlacedOutput> outputs = new ArrayList<>();
    private final List<PlacedInput> inputs = new ArrayList<>();

    private final Map<String, Place> places = new LinkedHashMap<>();
    private final Map<String, Transition> transitions = new LinkedHashMap<>();
    private final List<Plan> parents;
    private final Map<String, Integer> placeIndex;
    private final Map<String, Integer> transitionIndex;
    private final Map<String, Integer> edgeIndex;
    private final Map<String, List<PlacedInput>> inputsByTransition;
    private final Map<String, List<InEdge>> inEdges;
    private final Map<String, List<OutEdge>> outEdges;
    private final Map<String, List<InEdge>> edgesOutOf;
    private final Map<String, List<OutEdge>> edgesInto;

    PlanContext(Project project, Vocabulary vocabulary, Plan plan) {
        this.project = project;
        this.vocabulary = vocabulary;
        this.plan = plan;
        this.pointer = "/plans/" + indexOf(plan, project.plans());
        plan.places().forEach(p -> places.putIfAbsent(p.id(), p));
        plan.transitions().forEach(t -> transitions.putIfAbsent(t.id(), t));
        placeIndex = index(plan.places(), Place::id);
        transitionIndex = index(plan.transitions(), Transition::id);
        edgeIndex = index(plan.inEdges(), InEdge::id);
        edgeIndex.putAll(index(plan.outEdges(), OutEdge::id));
        inEdges = plan.inEdges().stream().collect(Collectors.groupingBy(InEdge::transition));
        outEdges = plan.outEdges().stream().collect(Collectors.groupingBy(OutEdge::transition));
        edgesOutOf = plan.inEdges().stream().collect(Collectors.groupingBy(InEdge::place));
        edgesInto = plan.outEdges().stream().collect(Collectors.groupingBy(OutEdge::place));
        parents = findParents();
        findEvents();
        inputsByTransition = inputs.stream()
                .collect(Collectors.groupingBy(i -> i.transition().id()));
    }

    /** The plan's index, by identity: comparing whole plans would take long in a project of many alike. */
    @SuppressWarnings("ReferenceEquality")
    private static int indexOf(Plan plan, List<Plan> plans) {
        for (int i = 0; i < plans.size(); i++) {
            if (plans.get(i) == plan) {
                return i;
            }
        }
        throw new IllegalArgumentException("The project has no plan " + plan.id());
    }

    private static <T> Map<String, Integer> index(List<T> elements, Function<T, String> id) {
        Map<String, Integer> index = new HashMap<>();
        for (int i = 0; i < elements.size(); i++) {
            index.putIfAbsent(id.apply(elements.get(i)), i);
        }
        return index;
    }

    private void findEvents() {
        for (Place place : plan.places()) {
            for (int i = 0; i < place.outputs().size(); i++) {
                OutputEventSpec spec = place.outputs().get(i);
                String where = at(place) + "/outputs/" + i;
                vocabulary
                        .event(spec.type())
                        .ifPresent(type -> outputs.add(new PlacedOutput(place, spec, type, where)));
            }
        }
        for (Transition transition : plan.transitions()) {
            for (int i = 0; i < transition.inputs().size(); i++) {
                InputEventSpec spec = transition.inputs().get(i);
                String where = at(transition) + "/inputs/" + i;
                vocabulary
                        .event(spec.type())
                        .ifPresent(type -> inputs.add(new PlacedInput(transition, spec, type, where)));
            }
        }
    }

    Project project() {
        return project;
    }

    Vocabulary vocabulary() {
        return vocabulary;
    }

    Plan plan() {
        return plan;
    }

    String pointer() {
        return pointer;
    }

    /** Output events whose type is known, in document order. */
    List<PlacedOutput> outputs() {
        return outputs;
    }

    /** Input events whose type is known, in document order. */
    List<PlacedInput> inputs() {
        return inputs;
    }

    List<PlacedInput> inputsOf(Transition transition) {
        return inputsByTransition.getOrDefault(transition.id(), List.of());
    }

    List<InEdge> inEdges(Transition transition) {
        return inEdges.getOrDefault(transition.id(), List.of());
    }

    List<OutEdge> outEdges(Transition transition) {
        return outEdges.getOrDefault(transition.id(), List.of());
    }

    List<OutEdge> edgesInto(Place place) {
        return edgesInto.getOrDefault(place.id(), List.of());
    }

    List<Place> inPlaces(Transition transition) {
        return inEdges(transition).stream()
                .map(e -> places.get(e.place()))
                .filter(Objects::nonNull)
                .toList();
    }

    List<Place> outPlaces(Transition transition) {
        return outEdges(transition).stream()
                .map(e -> places.get(e.place()))
                .filter(Objects::nonNull)
                .toList();
    }

    List<Transition> outTransitions(Place place) {
        return edgesOutOf.getOrDefault(place.id(), List.of()).stream()
                .map(e -> transitions.get(e.transition()))
                .filter(Objects::nonNull)
                .toList();
    }

    /** The types of the input events for which the transitions after a place wait, by name. */
    Set<String> awaitedAfter(Place place) {
        return outTransitions(place).stream()
                .flatMap(t -> inputsOf(t).stream())
                .map(input -> input.type().name())
                .collect(Collectors.toCollection(LinkedHashSet::new));
    }

    Optional<Place> place(String id) {
        return Optional.ofNullable(places.get(id));
    }

    Optional<Transition> transition(String id) {
        return Optional.ofNullable(transitions.get(id));
    }

    Optional<Plan> child(SubMissionSpec subMission) {
        return project.plan(subMission.plan());
    }

    /** Plans that run this one as a sub-mission. */
    List<Plan> parents() {
        return parents;
    }

    private List<Plan> findParents() {
        return project.plans().stream()
                .filter(p -> p.places().stream()
                        .flatMap(place -> place.subMissions().stream())
                        .anyMatch(s -> s.plan().equals(plan.id())))
                .toList();
    }

    String at(Place place) {
        return pointer + "/places/" + placeIndex.get(place.id());
    }

    String at(Transition transition) {
        return pointer + "/transitions/" + transitionIndex.get(transition.id());
    }

    String at(InEdge edge) {
        return pointer + "/inEdges/" + edgeIndex.get(edge.id());
    }

    String at(OutEdge edge) {
        return pointer + "/outEdges/" + edgeIndex.get(edge.id());
    }

    /** A place as messages speak of it. */
    static String name(Place place) {
        return "place \"" + (place.name().isEmpty() ? place.id() : place.name()) + "\"";
    }

    /** A transition as messages speak of it. */
    static String name(Transition transition) {
        return "transition \"" + (transition.name().isEmpty() ? transition.id() : transition.name()) + "\"";
    }

    /** An output event of a known type, where it stands. */
    record PlacedOutput(Place place, OutputEventSpec spec, EventType type, String pointer) {}

    /** An input event of a known type, where it stands. */
    record PlacedInput(Transition transition, InputEventSpec spec, EventType type, String pointer) {}
}
