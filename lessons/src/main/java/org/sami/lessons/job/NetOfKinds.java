package org.sami.lessons.job;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.LinkedHashSet;
import java.util.Map;
import java.util.Set;
import java.util.function.Predicate;
import org.sami.spn.model.InEdge;
import org.sami.spn.model.OutEdge;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Transition;
import org.sami.spn.vocabulary.EventType;
import org.sami.spn.vocabulary.Vocabulary;

/** One net, asked by kinds of vertices: those with an event of a type, {@code start}, {@code end}, {@code blank}, {@code name:…}. */
record NetOfKinds(Plan plan, Vocabulary vocabulary) {
    /** Begins the kind of vertices that have a name. */
    static final String BY_NAME = "name:";

    private String canonical(String type) {
        return vocabulary.event(type).map(EventType::name).orElse(type);
    }

    private static boolean isNamed(String kind, String name) {
        return name.strip().equalsIgnoreCase(kind.substring(BY_NAME.length()).strip());
    }

    private Predicate<Place> place(String kind) {
        if (kind.startsWith(BY_NAME)) {
            return place -> isNamed(kind, place.name());
        }
        return switch (kind) {
            case "start" -> Place::start;
            case "end" -> Place::end;
            case "blank" ->
                place -> place.outputs().isEmpty() && place.subMissions().isEmpty();
            default ->
                place -> place.outputs().stream()
                        .anyMatch(output -> canonical(output.type()).equals(canonical(kind)));
        };
    }

    private Predicate<Transition> transition(String kind) {
        if (kind.startsWith(BY_NAME)) {
            return transition -> isNamed(kind, transition.name());
        }
        return kind.equals("blank")
                ? transition -> transition.inputs().isEmpty()
                : transition -> transition.inputs().stream()
                        .anyMatch(input -> canonical(input.type()).equals(canonical(kind)));
    }

    private boolean isPlace(String id, Predicate<Place> wanted) {
        return plan.place(id).filter(wanted).isPresent();
    }

    private boolean isTransition(String id, Predicate<Transition> wanted) {
        return plan.transition(id).filter(wanted).isPresent();
    }

    boolean edgeRequires(String from, String to, Map<String, JsonNode> wanted) {
        for (InEdge edge : plan.inEdges()) {
            boolean fits =
                    wanted.isEmpty() || edge.requirements().stream().anyMatch(r -> RequirementMembers.fit(r, wanted));
            if (fits && isPlace(edge.place(), place(from)) && isTransition(edge.transition(), transition(to))) {
                return true;
            }
        }
        for (OutEdge edge : plan.outEdges()) {
            boolean fits =
                    wanted.isEmpty() || edge.requirements().stream().anyMatch(r -> RequirementMembers.fit(r, wanted));
            if (fits && isTransition(edge.transition(), transition(from)) && isPlace(edge.place(), place(to))) {
                return true;
            }
        }
        return false;
    }

    boolean silentEdgeRequires(Map<String, JsonNode> wanted) {
        return plan.inEdges().stream()
                .filter(edge -> isTransition(edge.transition(), transition("blank")))
                .anyMatch(edge -> edge.requirements().stream().anyMatch(r -> RequirementMembers.fit(r, wanted)));
    }

    /** Whether a way leads from one kind to another, over a third unless that is empty text. */
    boolean leads(String from, String to, String through) {
        Set<String> reached = reached(vertices(from));
        if (!through.isEmpty()) {
            Set<String> middle = vertices(through);
            middle.retainAll(reached);
            reached = reached(middle);
        }
        reached.retainAll(vertices(to));
        return !reached.isEmpty();
    }

    private Set<String> vertices(String kind) {
        Set<String> found = new LinkedHashSet<>();
        plan.places().stream().filter(place(kind)).forEach(place -> found.add(place.id()));
        plan.transitions().stream().filter(transition(kind)).forEach(t -> found.add(t.id()));
        return found;
    }

    /** What is reached from vertices by one edge at least. */
    private Set<String> reached(Set<String> from) {
        Set<String> reached = new LinkedHashSet<>();
        Deque<String> open = new ArrayDeque<>(from);
        while (!open.isEmpty()) {
            String vertex = open.pop();
            plan.inEdges().stream()
                    .filter(edge -> edge.place().equals(vertex) && reached.add(edge.transition()))
                    .forEach(edge -> open.push(edge.transition()));
            plan.outEdges().stream()
                    .filter(edge -> edge.transition().equals(vertex) && reached.add(edge.place()))
                    .forEach(edge -> open.push(edge.place()));
        }
        return reached;
    }
}
