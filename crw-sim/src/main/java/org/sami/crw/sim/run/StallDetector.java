package org.sami.crw.sim.run;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import org.sami.boat.server.vehicle.PlaneMath;
import org.sami.crw.fleet.FleetWants;
import org.sami.crw.operator.DecisionQueue;
import org.sami.crw.operator.StuckWatch;
import org.sami.crw.operator.decision.PendingDecision;
import org.sami.crw.operator.mission.StuckMission;
import org.sami.crw.session.Session;
import org.sami.crw.sim.run.operator.InterruptScheduler;
import org.sami.crw.sim.run.operator.SimulatedOperatorDriver;
import org.sami.crw.sim.run.record.BoatState;
import org.sami.crw.sim.run.record.RunMission;
import org.sami.crw.sim.run.record.RunRecords;
import org.sami.spn.engine.EngineView;
import org.sami.spn.host.EngineHost;

/**
 * Detects that a run is stuck: no timer runs, no answer is pending, no interrupt is due, and no boat executes a command of a mission. Boats without a
 * command may drift. A stuck mission would otherwise end only at the run's time limit.
 */
final class StallDetector {
    /** After this time without an input, no answer of a service or sensor is expected either. */
    private static final long QUIET_MILLIS = 300_000;

    /**
     * A run is stuck when no boat with a command has made progress for this long; a path without headway is given up after half of it
     * (docs/command-line.md).
     */
    private static final long STUCK_MILLIS = 600_000;

    /** Movement that counts as progress, in metres: more than a boat drifts that keeps a station or waits. */
    private static final double PROGRESS_M = 15;

    /** Within this time all questions and messages that follow from an input have been posted. */
    private static final long SETTLED_MILLIS = 5_000;

    private static final double REST_SPEED_MPS = 0.05;

    private final EngineHost host;
    private final DecisionQueue decisions;
    private final StuckWatch stuck;
    private final SimulatedOperatorDriver operator;
    private final InterruptScheduler interrupts;
    private final RunMission mission;
    private final int missions;
    private final Map<String, BoatState> places = new HashMap<>(); // position of each boat when it last made progress
    private long lastSomewhereMillis;

    /**
     * A detector for one run.
     *
     * @param missions how many it starts
     */
    StallDetector(int missions, Session session, RunRecords records) {
        this.missions = missions;
        host = session.host();
        decisions = session.models().decisions();
        stuck = session.models().stuck();
        operator = records.operator();
        interrupts = records.interrupts();
        mission = records.mission();
    }

    /**
     * The reason why nothing can happen; empty while something can.
     *
     * @param hasWork whether a mission wants something of a boat, by its name
     */
    Optional<String> look(long nowMillis, List<BoatState> boats, Predicate<String> hasWork) {
        follow(nowMillis, boats, hasWork);
        long quietMillis = nowMillis - mission.lastInputMillis();
        if (mission.started() < missions
                || quietMillis <= SETTLED_MILLIS
                || operator.isThinking()
                || interrupts.hasPlans()
                || host.ask(EngineView::nextDueMillis).isPresent()) {
            return Optional.empty();
        }
        boolean nobodyMoves =
                boats.stream().allMatch(boat -> !hasWork.test(boat.id()) || Math.abs(boat.speedMps()) < REST_SPEED_MPS);
        boolean noBoatHasWork = boats.stream().noneMatch(boat -> hasWork.test(boat.id()));
        boolean atOnce = noBoatHasWork
                && !interrupts.waitForBatteries()
                && !host.ask(view -> stuck.isNewsAwaited(view, FleetWants.NOTHING));
        boolean nobodyCan = boats.stream().noneMatch(boat -> hasWork.test(boat.id()) && boat.batteryPercent() > 0);
        boolean nobodyGetsOn = nobodyMoves && (nobodyCan || nowMillis - lastSomewhereMillis > STUCK_MILLIS);
        return atOnce || (nobodyGetsOn && quietMillis > QUIET_MILLIS)
                ? Optional.of(reason(nowMillis, boats))
                : Optional.empty();
    }

    /** Records when a boat that has work and charge last made progress. */
    private void follow(long nowMillis, List<BoatState> boats, Predicate<String> hasWork) {
        for (BoatState boat : boats) {
            BoatState before = places.putIfAbsent(boat.id(), boat);
            if (before != null
                    && PlaneMath.length(boat.eastM() - before.eastM(), boat.northM() - before.northM()) > PROGRESS_M) {
                places.put(boat.id(), boat);
                if (hasWork.test(boat.id()) && boat.batteryPercent() > 0) {
                    lastSomewhereMillis = nowMillis;
                }
            }
        }
    }

    private String reason(long nowMillis, List<BoatState> boats) {
        List<PendingDecision> open = decisions.pending();
        if (!open.isEmpty()) {
            return "nobody answers: "
                    + open.stream().map(pending -> pending.decision().prompt()).collect(Collectors.joining("; "))
                    + operator.troubles().stream().map(t -> " (" + t + ")").collect(Collectors.joining());
        }
        String empty = boats.stream()
                .filter(boat -> boat.batteryPercent() <= 0)
                .map(BoatState::id)
                .collect(Collectors.joining(", "));
        String failed = host.ask(view -> stuck.now(view, FleetWants.NOTHING, nowMillis)).stream()
                .filter(StuckMission::canBeSentAgain)
                .map(failing -> "; " + failing.what())
                .collect(Collectors.joining());
        return "nothing can happen in the mission any longer"
                + failed
                + (empty.isEmpty() ? "" : "; empty battery: " + empty);
    }
}
