package org.sami.spn.planspace;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.function.IntUnaryOperator;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.sami.petri.coverability.SaturatedQueries;
import org.sami.petri.graph.ReachabilityGraph;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Transition;
import org.sami.spn.plannet.PlanNet;
import org.sami.spn.plannet.PlanNetPlace;
import org.sami.spn.plannet.PlanNetPlace.Role;

/**
 * What holds of all states that a search of a plan's net has found. Of a bounded search it holds for those states only.
 *
 * @param graph the states
 * @param gathering places of the plan whose generic tokens are not counted, as they gather: a state says only whether there are any
 * @param neverFired ids of transitions that fire in none of them, in the order of the plan
 * @param mostRobots how many robots stand in a place at once at most, by the place's id, in the order of the plan; empty where they are not counted
 */
public record PlanFacts(
        ReachabilityGraph graph, List<String> gathering, List<String> neverFired, Map<String, Integer> mostRobots) {
    public PlanFacts {
        Objects.requireNonNull(graph, "graph");
        gathering = List.copyOf(gathering);
        neverFired = List.copyOf(neverFired);
        mostRobots = Collections.unmodifiableMap(new LinkedHashMap<>(mostRobots));
    }

    /** The facts of a graph, in which states may be one that differ by an exchange of robots. */
    static PlanFacts of(PlanNet net, ReachabilityGraph graph) {
        return of(net, graph, List.of(), t -> t);
    }

    /** The facts of a graph in which tokens that gather are not counted. */
    static PlanFacts of(PlanNet net, SaturatedQueries few) {
        List<String> gathering = few.net().places().stream()
                .mapToObj(place -> net.place(place).planPlace())
                .distinct()
                .toList();
        return of(net, few.graph(), gathering, few.net()::original);
    }

    private static PlanFacts of(
            PlanNet net, ReachabilityGraph graph, List<String> gathering, IntUnaryOperator original) {
        Plan plan = net.request().project().plan(net.request().plan()).orElseThrow();
        Set<Integer> dead = Set.copyOf(graph.deadTransitions());
        Set<String> fired = IntStream.range(0, graph.net().transitionCount())
                .filter(t -> !dead.contains(t))
                .mapToObj(t -> net.firing(original.applyAsInt(t)).transition())
                .collect(Collectors.toSet());
        List<String> never = plan.transitions().stream()
                .map(Transition::id)
                .filter(id -> !fired.contains(id))
                .toList();
        return new PlanFacts(graph, gathering, never, net.isPresent() ? Map.of() : mostRobots(net, plan, graph));
    }

    private static Map<String, Integer> mostRobots(PlanNet net, Plan plan, ReachabilityGraph graph) {
        List<String> ids = plan.places().stream().map(Place::id).toList();
        int[] of = IntStream.range(0, net.net().placeCount())
                .map(i ->
                        isOfRobots(net, net.place(i)) ? ids.indexOf(net.place(i).planPlace()) : -1)
                .toArray();
        int[] most = new int[ids.size()];
        for (int state = 0; state < graph.states(); state++) {
            int[] marking = graph.marking(state);
            int[] here = new int[ids.size()];
            for (int i = 0; i < of.length; i++) {
                if (of[i] >= 0) {
                    here[of[i]] += marking[i];
                }
            }
            for (int i = 0; i < most.length; i++) {
                most[i] = Math.max(most[i], here[i]);
            }
        }
        Map<String, Integer> byPlace = new LinkedHashMap<>();
        for (int i = 0; i < most.length; i++) {
            byPlace.put(ids.get(i), most[i]);
        }
        return byPlace;
    }

    private static boolean isOfRobots(PlanNet net, PlanNetPlace place) {
        return place.role() == Role.TOKEN && net.isRobot(place.token());
    }
}
