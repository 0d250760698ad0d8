package org.sami.spn.model;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;

/**
 * A plan: one SAMI Petri Net (thesis 3.1). Order of lists is meaning: places, transitions and edges are looked at in it.
 *
 * @param id stable, unique in the project
 * @param description a few sentences for whoever chooses a plan
 * @param variables variables declared by this plan (it writes or owns them)
 * @param reads names of variables that it expects of its parents or the project
 * @param layout of vertices, by id
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
        List<String> notes,
        List<TestCase> testCases) {
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
        testCases = List.copyOf(testCases);
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
}
