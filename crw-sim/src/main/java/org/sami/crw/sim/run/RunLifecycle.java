package org.sami.crw.sim.run;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Supplier;
import org.sami.crw.report.RunOutcome;
import org.sami.crw.session.Session;
import org.sami.crw.sim.run.record.BoatState;
import org.sami.crw.sim.run.record.RunMission;
import org.sami.crw.sim.run.record.RunRecords;
import org.sami.crw.sim.run.settings.PlannedMission;
import org.sami.crw.sim.run.settings.RunInput;
import org.sami.spn.host.HostStatus;
import org.sami.spn.protocol.Input;

/**
 * Starts the missions of a run, the first one when its boats have joined, and decides whether and how the run is over: with its missions, by a fault,
 * or because nothing can happen any longer. For the engine's thread.
 */
public final class RunLifecycle {
    private final RunInput input;
    private final Session session;
    private final RunMission mission;
    private final StallDetector stall;
    private Optional<String> fault = Optional.empty();
    private final int boats; // that join before the first mission begins
    private int started; // number of missions

    /**
     * For one run, which has not begun.
     *
     * @param boats how many boats it has; fewer than addresses where two of these lead to one boat
     */
    RunLifecycle(RunInput input, int boats, Session session, RunRecords records) {
        this.input = input;
        this.boats = Math.min(boats, input.settings().fleet().boats());
        this.session = session;
        mission = records.mission();
        stall = new StallDetector(input.missions().size(), session, records);
    }

    /** Takes over what earlier processes did: the mission may be running already. */
    public void caughtUp() {
        started = mission.started();
    }

    /** Whether the first mission was started. */
    boolean hasStarted() {
        return started > 0;
    }

    /** Starts the first mission, once, if all its boats have joined. */
    public void startWhenAllHaveJoined() {
        if (started == 0 && mission.boatsJoined() >= boats) {
            start(input.missions().get(0));
        }
    }

    /** Starts missions that are due, counted from the start of the first. */
    private void startLaterOnes() {
        while (started < input.missions().size()
                && mission.startedAtMillis().isPresent()
                && session.scheduler().nowMs()
                        >= mission.startedAtMillis().getAsLong()
                                + input.missions().get(started).afterMillis()) {
            start(input.missions().get(started));
        }
    }

    private void start(PlannedMission next) {
        started++;
        session.host().post(new Input.StartMission(next.plan().id(), next.name(), next.parameters()));
    }

    /** Whether and how the run is over; called repeatedly. */
    public Optional<RunOutcome> outcome() {
        HostStatus status = session.host().status();
        if (status.kind() == HostStatus.Kind.FAILED) {
            fail(status.whole());
        }
        Optional<String> failure = mission.failure();
        if (failure.isPresent()) {
            fail(failure.get());
        }
        startLaterOnes();
        Optional<RunOutcome> outcome = fault.isEmpty() ? mission.result() : Optional.empty();
        if (outcome.isPresent()) {
            if (outcome.get() == RunOutcome.FAILED) {
                fail("the mission was halted: it fired without end (livelock)");
            }
            return outcome;
        }
        return fault.isPresent() ? Optional.of(RunOutcome.FAILED) : Optional.empty();
    }

    /** Ends the run with a fault; the first fault counts. */
    public void fail(String reason) {
        if (fault.isEmpty()) {
            fault = Optional.of(reason);
        }
    }

    /** The reason of the failure in one sentence; empty while there is none. */
    public Optional<String> fault() {
        return fault;
    }

    /**
     * Checks whether anything can still happen, and fails the run if nothing can. Waits until the fleet's thread has reported which boats have
     * commands: on a busy machine a new command may not have reached its boat yet.
     *
     * @param boats as they are then
     */
    public void lookForStall(Supplier<List<BoatState>> boats) {
        session.boatsWithWork(wanted -> lookForStall(boats.get(), wanted));
    }

    private void lookForStall(List<BoatState> boats, Set<String> wanted) {
        if (session.isComputing()) {
            return; // commands may follow
        }
        long now = session.scheduler().nowMs();
        if (!input.settings().isConnected()) {
            stall.look(now, boats, wanted::contains).ifPresent(this::fail);
        } else if (wanted.stream()
                .noneMatch(boat -> canMove(boat, boats))) { // otherwise a link or its operator may come back
            stall.look(now, boats, boat -> false).ifPresent(this::fail);
        }
    }

    private static boolean canMove(String boat, List<BoatState> boats) {
        return boats.stream().noneMatch(one -> one.id().equals(boat) && one.batteryPercent() <= 0);
    }
}
