package org.sami.spn.model;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;

/**
 * A plan: one SAMI Petri Net (thesis 3.1). Order of lists is meaning: places, transitions and edges are looked at in it.
 *
 * @param id stable, unique in the project
 * @param description a few sentences for those who choose a plan
 * @param variables variables declared by this plan (it writes or owns them)
 * @param reads names of variables that it expects of its parents or the project
 * @param layout of vertices, by id
 * @param frames of groups on the drawing
 * @param queries questions about what the plan can do, which searches answer
 */
public record Plan(
        String id,
        String name,
        String description,
        List<Place> places,
        List<Transition> transitions,
        List<InEdge> inEdges,
        List<OutEdge> outEdges,
        List<VariableSpec> variables,
        List<String> reads,
        List<TaskSpec> tasks,
        Map<String, LayoutPoint> layout,
        List<Note> notes,
        List<NetFrame> frames,
        List<TestCase> testCases,
        List<PlanQuery> queries) {
    public Plan {
        Objects.requireNonNull(id, "id");
        Objects.requireNonNull(name, "name");
        Objects.requireNonNull(description, "description");
        places = List.copyOf(places);
        transitions = List.copyOf(transitions);
        inEdges = List.copyOf(inEdges);
        outEdges = List.copyOf(outEdges);
        variables = List.copyOf(variables);
        reads = List.copyOf(reads);
        tasks = List.copyOf(tasks);
        layout = Collections.unmodifiableMap(new LinkedHashMap<>(layout));
        notes = List.copyOf(notes);
        frames = List.copyOf(frames);
        testCases = List.copyOf(testCases);
        queries = List.copyOf(queries);
    }

    /** A plan without frames and queries. */
    public Plan(
            String id,
            String name,
            String description,
            List<Place> places,
            List<Transition> transitions,
            List<InEdge> inEdges,
            List<OutEdge> outEdges,
            List<VariableSpec> variables,
            List<String> reads,
            List<TaskSpec> tasks,
            Map<String, LayoutPoint> layout,
            List<Note> notes,
            List<TestCase> testCases) {
        this(
                id,
                name,
                description,
                places,
                transitions,
                inEdges,
                outEdges,
                variables,
                reads,
                tasks,
                layout,
                notes,
                List.of(),
                testCases,
                List.of());
    }

    /** What people call it: its name, or its id where the author gave it none. */
    public String title() {
        return name.isBlank() ? id : name;
    }

    /** The place of that id. */
    public Optional<Place> place(String placeId) {
        return places.stream().filter(p -> p.id().equals(placeId)).findFirst();
    }

    /** The transition of that id. */
    public Optional<Transition> transition(String transitionId) {
        return transitions.stream().filter(t -> t.id().equals(transitionId)).findFirst();
    }

    /** The first start place; plans that passed the checks have exactly one. */
    public Optional<Place> startPlace() {
        return places.stream().filter(Place::start).findFirst();
    }

    /** In edges of a transition, in order. */
    public List<InEdge> inEdgesOf(String transitionId) {
        return inEdges.stream().filter(e -> e.transition().equals(transitionId)).toList();
    }

    /** Out edges of a transition, in order. */
    public List<OutEdge> outEdgesOf(String transitionId) {
        return outEdges.stream()
                .filter(e -> e.transition().equals(transitionId))
                .toList();
    }

    /** Ids of all its elements: vertices, edges, events and sub-missions. */
    public Set<String> elementIds() {
        Set<String> ids = new LinkedHashSet<>();
        places.forEach(place -> {
            ids.add(place.id());
            place.outputs().forEach(event -> ids.add(event.id()));
            place.subMissions().forEach(sub -> ids.add(sub.id()));
        });
        transitions.forEach(transition -> {
            ids.add(transition.id());
            transition.inputs().forEach(event -> ids.add(event.id()));
        });
        inEdges.forEach(edge -> ids.add(edge.id()));
        outEdges.forEach(edge -> ids.add(edge.id()));
        return ids;
    }

    /** The same plan with another id. */
    public Plan withId(String id) {
        return new Plan(
                id,
                name,
                description,
                places,
                transitions,
                inEdges,
                outEdges,
                variables,
                reads,
                tasks,
                layout,
                notes,
                frames,
                testCases,
                queries);
    }

    /** The same plan with another name. */
    public Plan withName(String name) {
        return new Plan(
                id,
                name,
                description,
                places,
                transitions,
                inEdges,
                outEdges,
                variables,
                reads,
                tasks,
                layout,
                notes,
                frames,
                testCases,
                queries);
    }

    /** The same plan with another description. */
    public Plan withDescription(String description) {
        return new Plan(
                id,
                name,
                description,
                places,
                transitions,
                inEdges,
                outEdges,
                variables,
                reads,
                tasks,
                layout,
                notes,
                frames,
                testCases,
                queries);
    }

    /** The same plan with other places. */
    public Plan withPlaces(List<Place> places) {
        return new Plan(
                id,
                name,
                description,
                places,
                transitions,
                inEdges,
                outEdges,
                variables,
                reads,
                tasks,
                layout,
                notes,
                frames,
                testCases,
                queries);
    }

    /** The same plan with other transitions. */
    public Plan withTransitions(List<Transition> transitions) {
        return new Plan(
                id,
                name,
                description,
                places,
                transitions,
                inEdges,
                outEdges,
                variables,
                reads,
                tasks,
                layout,
                notes,
                frames,
                testCases,
                queries);
    }

    /** The same plan with other in edges. */
    public Plan withInEdges(List<InEdge> inEdges) {
        return new Plan(
                id,
                name,
                description,
                places,
                transitions,
                inEdges,
                outEdges,
                variables,
                reads,
                tasks,
                layout,
                notes,
                frames,
                testCases,
                queries);
    }

    /** The same plan with other out edges. */
    public Plan withOutEdges(List<OutEdge> outEdges) {
        return new Plan(
                id,
                name,
                description,
                places,
                transitions,
                inEdges,
                outEdges,
                variables,
                reads,
                tasks,
                layout,
                notes,
                frames,
                testCases,
                queries);
    }

    /** The same plan with other variables. */
    public Plan withVariables(List<VariableSpec> variables) {
        return new Plan(
                id,
                name,
                description,
                places,
                transitions,
                inEdges,
                outEdges,
                variables,
                reads,
                tasks,
                layout,
                notes,
                frames,
                testCases,
                queries);
    }

    /** The same plan with other variables that it expects of its parents. */
    public Plan withReads(List<String> reads) {
        return new Plan(
                id,
                name,
                description,
                places,
                transitions,
                inEdges,
                outEdges,
                variables,
                reads,
                tasks,
                layout,
                notes,
                frames,
                testCases,
                queries);
    }

    /** The same plan with other tasks. */
    public Plan withTasks(List<TaskSpec> tasks) {
        return new Plan(
                id,
                name,
                description,
                places,
                transitions,
                inEdges,
                outEdges,
                variables,
                reads,
                tasks,
                layout,
                notes,
                frames,
                testCases,
                queries);
    }

    /** The same plan with another layout. */
    public Plan withLayout(Map<String, LayoutPoint> layout) {
        return new Plan(
                id,
                name,
                description,
                places,
                transitions,
                inEdges,
                outEdges,
                variables,
                reads,
                tasks,
                layout,
                notes,
                frames,
                testCases,
                queries);
    }

    /** The same plan with other notes. */
    public Plan withNotes(List<Note> notes) {
        return new Plan(
                id,
                name,
                description,
                places,
                transitions,
                inEdges,
                outEdges,
                variables,
                reads,
                tasks,
                layout,
                notes,
                frames,
                testCases,
                queries);
    }

    /** The same plan with other frames. */
    public Plan withFrames(List<NetFrame> frames) {
        return new Plan(
                id,
                name,
                description,
                places,
                transitions,
                inEdges,
                outEdges,
                variables,
                reads,
                tasks,
                layout,
                notes,
                frames,
                testCases,
                queries);
    }

    /** The same plan with other test cases. */
    public Plan withTestCases(List<TestCase> testCases) {
        return new Plan(
                id,
                name,
                description,
                places,
                transitions,
                inEdges,
                outEdges,
                variables,
                reads,
                tasks,
                layout,
                notes,
                frames,
                testCases,
                queries);
    }

    /** The same plan with other queries. */
    public Plan withQueries(List<PlanQuery> queries) {
        return new Plan(
                id,
                name,
                description,
                places,
                transitions,
                inEdges,
                outEdges,
                variables,
                reads,
                tasks,
                layout,
                notes,
                frames,
                testCases,
                queries);
    }
}
