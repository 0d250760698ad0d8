package org.sami.spn.analysis;

import java.util.ArrayList;
import java.util.Collection;
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
import org.sami.spn.naming.ElementNames;
import org.sami.spn.vocabulary.EventType;
import org.sami.spn.vocabulary.Vocabulary;

/** A plan with what surrounds it, and the questions that checks ask about neighbours and places in the document. */
final class PlanContext {
    private final ProjectContext project;
    private final Plan plan;
    private final String pointer;
    private final List<PlacedOutput> outputs;
    private final List<PlacedInput> inputs;
    private final Map<String, Place> places;
    private final Map<String, Transition> transitions;
    private final Map<String, Integer> placeIndex;
    private final Map<String, Integer> transitionIndex;
    private final Map<String, Integer> edgeIndex;
    private final Map<String, List<PlacedInput>> inputsByTransition;
    private final Map<String, List<PlacedOutput>> outputsByPlace;
    private final Map<String, List<InEdge>> inEdges;
    private final Map<String, List<OutEdge>> outEdges;
    private final Map<String, List<InEdge>> edgesOutOf;
    private final Map<String, List<OutEdge>> edgesInto;
    private final VariableScope scope;
    private final ElementNames names;
    private Optional<KnownFields> known = Optional.empty();
    private Optional<TokenFlow> flow = Optional.empty();

    PlanContext(ProjectContext project, Plan plan, String pointer) {
        this.project = project;
        this.plan = plan;
        this.pointer = pointer;
        places = new LinkedHashMap<>();
        transitions = new LinkedHashMap<>();
        outputs = new ArrayList<>();
        inputs = new ArrayList<>();
        names = new ElementNames(plan, project.vocabulary());
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
        findEvents();
        inputsByTransition = inputs.stream()
                .collect(Collectors.groupingBy(i -> i.transition().id()));
        outputsByPlace =
                outputs.stream().collect(Collectors.groupingBy(o -> o.place().id()));
        scope = new VariableScope(this);
    }

    /** The same plan, of which everything is known, in another version of its project. */
    private PlanContext(ProjectContext project, PlanContext known) {
        this.project = project;
        this.plan = known.plan;
        this.pointer = known.pointer;
        this.outputs = known.outputs;
        this.inputs = known.inputs;
        this.places = known.places;
        this.transitions = known.transitions;
        this.placeIndex = known.placeIndex;
        this.transitionIndex = known.transitionIndex;
        this.edgeIndex = known.edgeIndex;
        this.inputsByTransition = known.inputsByTransition;
        this.outputsByPlace = known.outputsByPlace;
        this.inEdges = known.inEdges;
        this.outEdges = known.outEdges;
        this.edgesOutOf = known.edgesOutOf;
        this.edgesInto = known.edgesInto;
        this.scope = known.scope.in(this);
        this.names = known.names;
    }

    /** This plan in another version of its project, in which it stands at the same index. */
    PlanContext in(ProjectContext other) {
        return new PlanContext(other, this);
    }

    /** Another plan of the project. */
    PlanContext of(Plan other) {
        return project.of(other);
    }

    /** Who declares, reads and writes which variable. */
    VariableScope scope() {
        return scope;
    }

    /** The values of fields that are known before a run; made when they are first asked for. */
    KnownFields known() {
        if (known.isEmpty()) {
            known = Optional.of(new KnownFields(this));
        }
        return known.get();
    }

    /** Which kinds of tokens may stand where; made when it is first asked for. */
    TokenFlow flow() {
        if (flow.isEmpty()) {
            flow = Optional.of(new TokenFlow(this));
        }
        return flow.get();
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
                vocabulary()
                        .event(spec.type())
                        .ifPresent(type -> outputs.add(new PlacedOutput(place, spec, type, where)));
            }
        }
        for (Transition transition : plan.transitions()) {
            for (int i = 0; i < transition.inputs().size(); i++) {
                InputEventSpec spec = transition.inputs().get(i);
                String where = at(transition) + "/inputs/" + i;
                vocabulary()
                        .event(spec.type())
                        .ifPresent(type -> inputs.add(new PlacedInput(transition, spec, type, where)));
            }
        }
    }

    Project project() {
        return project.project();
    }

    Vocabulary vocabulary() {
        return project.vocabulary();
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

    List<PlacedOutput> outputsOf(Place place) {
        return outputsByPlace.getOrDefault(place.id(), List.of());
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
        return project.parents(plan.id());
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

    /** A place as messages speak of it, after an article. */
    String name(Place place) {
        return names.withKind(place);
    }

    /** A transition as messages speak of it, after an article. */
    String name(Transition transition) {
        return names.withKind(transition);
    }

    /** An output event as messages speak of it: with its place, unless that is called by the event. */
    String name(PlacedOutput output) {
        String title = output.type().title();
        boolean isPlace = ElementNames.called(output.place(), vocabulary()).equals(Optional.of(title));
        return isPlace ? title : title + " at the " + name(output.place());
    }

    /** An input event as messages speak of it: with its transition, unless that is called by the event. */
    String name(PlacedInput input) {
        boolean isTransition = input.transition().name().isBlank()
                && input.transition().inputs().indexOf(input.spec()) == 0;
        return input.type().title() + (isTransition ? "" : " at the " + name(input.transition()));
    }

    /** An event, or what else reads or writes variables, as messages speak of it, by its id. */
    String eventName(String id) {
        return outputs.stream()
                .filter(output -> output.spec().id().equals(id))
                .map(this::name)
                .findFirst()
                .or(() -> inputs.stream()
                        .filter(input -> input.spec().id().equals(id))
                        .map(this::name)
                        .findFirst())
                .or(() -> names.of(id))
                .orElse(id);
    }

    /** What people call the plan that a sub-mission runs. */
    String title(SubMissionSpec subMission) {
        return child(subMission).map(Plan::title).orElse(subMission.plan());
    }

    /** The titles of event types, such as "Yes or No". */
    String titles(Collection<String> types) {
        return types.stream().map(vocabulary()::title).collect(Collectors.joining(" or "));
    }

    /** A place as messages speak of it, by its id. */
    String placeName(String id) {
        return place(id).map(this::name).orElse("place \"" + id + "\"");
    }

    /** An edge as messages speak of it, after an article: {@code edge from the place "Go" to the transition 3}. */
    String name(InEdge edge) {
        return "edge from the " + placeName(edge.place()) + " to the " + nameOfTransition(edge.transition());
    }

    /** An edge as messages speak of it, after an article. */
    String name(OutEdge edge) {
        return "edge from the " + nameOfTransition(edge.transition()) + " to the " + placeName(edge.place());
    }

    /** A transition at the beginning of a message, by its id. */
    String transitionName(String id) {
        return "The " + nameOfTransition(id);
    }

    private String nameOfTransition(String id) {
        return transition(id).map(this::name).orElse("transition \"" + id + "\"");
    }

    /** An output event of a known type, where it stands. */
    record PlacedOutput(Place place, OutputEventSpec spec, EventType type, String pointer) {}

    /** An input event of a known type, where it stands. */
    record PlacedInput(Transition transition, InputEventSpec spec, EventType type, String pointer) {}
}
