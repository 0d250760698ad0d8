package org.sami.spn.statespace;

import java.util.List;
import java.util.Optional;
import org.sami.spn.finding.Advice;
import org.sami.spn.finding.Finding;
import org.sami.spn.finding.Severity;
import org.sami.spn.model.Plan;

/**
 * Finds a mission that cannot end any more once a robot was dropped from it while others are at work: it waits for who is gone. That is a note:
 * the operator drops a robot knowing why, and an abort always ends the mission; a plan for two robots makes no sense with one.
 */
final class StuckAfterDrop implements SpaceQuestion {
    static final String CODE = "N-STUCK-AFTER-DROP";

    @Override
    public String id() {
        return "stuck-after-drop";
    }

    @Override
    public String title() {
        return "Dropped robots";
    }

    @Override
    public String help() {
        return "Drops a robot at every state, one in a run, and looks for missions that then wait for it forever while"
                + " others work.";
    }

    @Override
    public boolean dropsRobots() {
        return true;
    }

    @Override
    public List<Advice> advice() {
        return List.of(new Advice(
                CODE,
                "When that robot is dropped the mission waits for it, and the operator has to abort it.",
                "Draw a transition for the news that the robot is gone, or leave it: an abort ends the " + "mission."));
    }

    @Override
    public List<DeepFinding> findings(Exploration found, DeepRequest request) {
        Plan plan = request.project().plan(request.plan()).orElseThrow();
        return StuckStates.stuck(found, request).stream()
                .filter(node -> node.dropped().isPresent())
                .findFirst()
                .map(node -> finding(request, plan, node))
                .stream()
                .toList();
    }

    private static DeepFinding finding(DeepRequest request, Plan plan, Node node) {
        String dropped = node.dropped().orElseThrow();
        String where = StuckStates.where(request, node);
        String message =
                "The plan \"" + plan.title() + "\" can end no more once " + dropped + " was dropped, where " + where
                        + SearchWords.when(request, node.steps())
                        + ": the operator has to abort it then; play it to see what waits for " + dropped;
        Finding finding = new Finding(Severity.NOTE, CODE, SearchWords.pointer(request, plan), message, node.marked())
                .inPlan(plan.id());
        return new DeepFinding(
                finding, Optional.of(node.witness("waits for a robot that was dropped: " + where, request.robots())));
    }

    @Override
    public String result(Exploration found, DeepRequest request) {
        if (found.afterDrops() == 0) {
            return "no robot could be dropped";
        }
        String states = found.afterDrops() == 1 ? "1 state" : found.afterDrops() + " states";
        String tried = found.areAllDropsTried()
                ? "a robot dropped at each of them leads to " + states + " more"
                : "of the states after a robot was dropped " + states + " were looked at";
        return findings(found, request).isEmpty() ? tried : tried + ", and the mission can wait for it forever";
    }
}
