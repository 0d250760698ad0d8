package org.sami.spn.statespace;

import java.util.ArrayDeque;
import java.util.Comparator;
import java.util.Deque;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.sami.spn.finding.Advice;
import org.sami.spn.finding.Finding;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;
import org.sami.spn.stepping.NextStep;

/**
 * Finds states from which no run comes to an end: whatever robots, services and operator do, the mission goes on forever or stands still.
 * Of states with tokens in the same places the one nearest to the start is reported.
 */
final class StuckStates implements SpaceQuestion {
    static final String STUCK = "W-STUCK";
    private static final int MOST = 20;

    @Override
    public String id() {
        return "stuck-states";
    }

    @Override
    public String title() {
        return "Stuck states";
    }

    @Override
    public String help() {
        return "Looks for states from which the mission cannot end any more, whatever is answered. Values are samples,"
                + " so a way that depends on a value may be missed.";
    }

    @Override
    public DeepResult run(DeepRequest request, SearchWatch watch) {
        return hasEnd(request)
                ? SpaceQuestion.super.run(request, watch)
                : new DeepResult(List.of(), 0, true, "The plan has no end place, so no state leads to one");
    }

    private static boolean hasEnd(DeepRequest request) {
        return request.project().plan(request.plan()).orElseThrow().places().stream()
                .anyMatch(Place::end);
    }

    @Override
    public List<Advice> advice() {
        return List.of(new Advice(
                STUCK,
                "From there no run comes to the end any more: the mission stands still or goes round until "
                        + "somebody aborts it.",
                "Play the run. Where it stops, draw a transition that leads on, or let the transition before "
                        + "it not come there."));
    }

    @Override
    public List<DeepFinding> findings(Exploration found, DeepRequest request) {
        Plan plan = request.project().plan(request.plan()).orElseThrow();
        return stuck(found, request).stream()
                .filter(node -> node.dropped().isEmpty())
                .limit(MOST)
                .map(node -> finding(request, plan, node))
                .toList();
    }

    /** The first state of each set of marked places from which no run comes to an end. */
    static List<Node> stuck(Exploration found, DeepRequest request) {
        if (!hasEnd(request) || SearchWords.isShared(request)) {
            return List.of();
        }
        Set<Node> hopeful = hopeful(found);
        Set<Node> usual = found.usual();
        Map<Set<String>, Node> stuck = new LinkedHashMap<>();
        found.nodes().stream()
                .filter(node -> usual.contains(node) && !hopeful.contains(node) && robotsWork(node, request))
                .sorted(Comparator.comparing((Node node) -> node.dropped().isPresent())
                        .thenComparing(Node::steps))
                .forEach(node -> stuck.putIfAbsent(Set.copyOf(node.marked()), node));
        return List.copyOf(stuck.values());
    }

    /** Whether a state has robots at work still after one was dropped: where the last one was, the mission waits for its operator. */
    private static boolean robotsWork(Node node, DeepRequest request) {
        Plan plan = request.project().plan(request.plan()).orElseThrow();
        PlanRoles roles = new PlanRoles(plan, request.vocabulary());
        return node.dropped().isEmpty()
                || node.withRobots().stream()
                        .flatMap(id -> plan.place(id).stream())
                        .anyMatch(place -> !place.start() && !roles.isChoice(place));
    }

    /** States from which an end was reached, or from which something leads to what was not looked at. */
    private static Set<Node> hopeful(Exploration found) {
        Set<Node> hopeful = new HashSet<>();
        Deque<Node> open = new ArrayDeque<>();
        for (Node node : found.nodes()) {
            if (node.isOver() || (!node.isLookedAt() && !node.isHalted())) {
                open.add(node);
            }
        }
        while (!open.isEmpty()) {
            Node node = open.pop();
            if (hopeful.add(node)) {
                node.before().stream()
                        .filter(edge ->
                                edge.step().kind() != NextStep.Kind.DROP) // an end by dropping robots is no way out
                        .forEach(edge -> open.add(edge.from()));
            }
        }
        return hopeful;
    }

    static String where(DeepRequest request, Node node) {
        return node.marked().isEmpty()
                ? "no token is left anywhere"
                : "tokens stand in " + SearchWords.places(request, node.marked());
    }

    private static DeepFinding finding(DeepRequest request, Plan plan, Node node) {
        List<String> marked = node.marked();
        String where = where(request, node);
        String how = node.isHalted() ? "fires without end and is halted" : "can end no more";
        String message = "The plan \"" + plan.title() + "\" " + how + " where " + where
                + SearchWords.when(request, node.steps()) + "; play it to see what is missing";
        Finding finding = Finding.warning(
                        STUCK, SearchWords.pointer(request, plan), message, marked.toArray(String[]::new))
                .inPlan(plan.id());
        return new DeepFinding(finding, Optional.of(node.witness("gets stuck: " + where, request.robots())));
    }

    @Override
    public String result(Exploration found, DeepRequest request) {
        if (SearchWords.isShared(request)) {
            return "as a shared sub-mission it continues when a token enters";
        }
        long stuck = stuck(found, request).stream()
                .filter(node -> node.dropped().isEmpty())
                .count();
        return stuck == 0
                ? "from each of them the mission can still end"
                : "in " + stuck + (stuck == 1 ? " marking" : " markings") + " it can end no more";
    }
}
