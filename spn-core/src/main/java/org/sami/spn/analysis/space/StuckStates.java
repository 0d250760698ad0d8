package org.sami.spn.analysis.space;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.sami.spn.analysis.space.Exploration.Node;
import org.sami.spn.finding.Finding;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;

/**
 * Finds states from which no run comes to an end: whatever robots, services and operator do, the mission goes on for ever or stands still.
 * Of states with tokens in the same places the one that is nearest to the start is told.
 */
final class StuckStates implements DeepCheck {
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
        return "Looks for states from which the mission cannot end any more, whatever is answered. Values are samples, so a way that depends on a"
                + " value may be missed.";
    }

    @Override
    public DeepResult run(DeepRequest request, SearchWatch watch) {
        Plan plan = request.project().plan(request.plan()).orElseThrow();
        if (plan.places().stream().noneMatch(Place::end)) {
            return new DeepResult(List.of(), 0, true, "The plan has no end place, so no state leads to one");
        }
        Exploration found = Exploration.of(request, watch);
        Set<Node> hopeful = hopeful(found);
        Map<Set<String>, Node> stuck = new LinkedHashMap<>();
        found.nodes().stream()
                .filter(node -> !hopeful.contains(node))
                .forEach(node -> stuck.putIfAbsent(node.marking().keySet(), node));
        List<DeepFinding> findings = new ArrayList<>();
        stuck.values().stream().limit(MOST).forEach(node -> findings.add(finding(request, plan, node)));
        return new DeepResult(findings, found.looked(), found.isComplete(), summary(found, stuck.size(), request));
    }

    /** States from which an end was reached, or from which something leads to what was not looked at. */
    private static Set<Node> hopeful(Exploration found) {
        Set<Node> hopeful = new HashSet<>();
        Deque<Node> open = new ArrayDeque<>();
        for (Node node : found.nodes()) {
            if (node.isOver() || !node.isLookedAt()) {
                open.add(node);
            }
        }
        while (!open.isEmpty()) {
            Node node = open.pop();
            if (hopeful.add(node)) {
                open.addAll(node.before());
            }
        }
        return hopeful;
    }

    private static DeepFinding finding(DeepRequest request, Plan plan, Node node) {
        List<String> marked = List.copyOf(node.marking().keySet());
        String where = marked.isEmpty()
                ? "no token is left anywhere"
                : "tokens stand in "
                        + String.join(
                                ", ", marked.stream().map(id -> name(plan, id)).toList());
        String how = node.isHalted() ? "fires without end and is halted" : "can end no more";
        String message = "The plan \"" + plan.name() + "\" " + how + " where " + where + " (" + steps(node.steps())
                + " from the start, " + robots(request) + "); play it to see what is missing";
        Finding finding = Finding.warning(STUCK, pointer(request, plan), message, marked.toArray(String[]::new))
                .inPlan(plan.id());
        return new DeepFinding(finding, Optional.of(node.witness("gets stuck: " + where, request.robots())));
    }

    static String pointer(DeepRequest request, Plan plan) {
        return "/plans/" + request.project().plans().indexOf(plan);
    }

    private static String name(Plan plan, String place) {
        return plan.place(place)
                .map(Place::name)
                .filter(name -> !name.isEmpty())
                .map(name -> "\"" + name + "\"")
                .orElse(place);
    }

    private static String steps(int steps) {
        return steps == 1 ? "1 step" : steps + " steps";
    }

    static String robots(DeepRequest request) {
        int robots = request.robots().size();
        return robots == 1 ? "1 robot" : robots + " robots";
    }

    private static String summary(Exploration found, int stuck, DeepRequest request) {
        String looked = found.looked() + " states with " + robots(request);
        String result = stuck == 0
                ? "from each of them the mission can still end"
                : "in " + stuck + (stuck == 1 ? " marking" : " markings") + " it can end no more";
        return found.isComplete()
                ? "All " + looked + " were looked at: " + result
                : "Of the first " + looked + ", " + result + "; there are more that were not looked at";
    }
}
