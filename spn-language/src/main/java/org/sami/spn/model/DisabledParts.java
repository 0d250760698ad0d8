package org.sami.spn.model;

import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** What authors have disabled for trying: transitions that never fire, places whose events are not sent and whose sub-missions do not start. */
public final class DisabledParts {
    private DisabledParts() {}

    /** The ids of the disabled vertices of a plan, in its order. */
    public static List<String> of(Plan plan) {
        return Stream.concat(
                        plan.places().stream().filter(Place::disabled).map(Place::id),
                        plan.transitions().stream().filter(Transition::disabled).map(Transition::id))
                .toList();
    }

    /** The warning about disabled vertices for the operator who starts a mission of a plan, to follow a sentence; empty text where it has none. */
    public static String remark(Plan plan) {
        String disabled = names(plan);
        return disabled.isEmpty() ? "" : "; it also does what is disabled for trying: " + disabled;
    }

    /** The same warning before a mission is started, one sentence without a full stop; empty text where it has none. */
    public static String warning(Plan plan) {
        String disabled = names(plan);
        return disabled.isEmpty() ? "" : "Also does what is disabled for trying: " + disabled;
    }

    private static String names(Plan plan) {
        return of(plan).stream()
                .map(id -> plan.place(id)
                        .map(Place::name)
                        .or(() -> plan.transition(id).map(Transition::name))
                        .filter(name -> !name.isEmpty())
                        .orElse(id))
                .collect(Collectors.joining(", "));
    }

    /** The project as it is tried, with nothing of what is disabled. Elements that are left have their ids. */
    public static Project leftOut(Project project) {
        return project.withPlans(
                project.plans().stream().map(DisabledParts::leftOut).toList());
    }

    private static Plan leftOut(Plan plan) {
        if (of(plan).isEmpty()) {
            return plan;
        }
        Set<String> gone = new HashSet<>();
        plan.transitions().stream().filter(Transition::disabled).forEach(t -> gone.add(t.id()));
        return plan.withPlaces(plan.places().stream()
                        .map(place -> leftOut(place, gone))
                        .toList())
                .withTransitions(
                        plan.transitions().stream().filter(t -> !t.disabled()).toList())
                .withInEdges(plan.inEdges().stream()
                        .filter(edge -> !gone.contains(edge.transition()))
                        .toList())
                .withOutEdges(plan.outEdges().stream()
                        .filter(edge -> !gone.contains(edge.transition()))
                        .toList());
    }

    private static Place leftOut(Place place, Set<String> gone) {
        Place ordered = place.withTransitionOrder(place.transitionOrder().stream()
                .filter(transition -> !gone.contains(transition))
                .toList());
        return place.disabled() ? ordered.withOutputs(List.of()).withSubMissions(List.of()) : ordered;
    }
}
