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
 * Starts the missions of a run, the first when its boats are there, and says whether and how the run is over: by its mission, by a fault, or since
 * nothing can happen any longer. For the engine's thread.
 */
public final class RunLifecycle {
    private final RunInput input;
    private final Session session;
    private final RunMission mission;
    private final StallDetector stall;
    private Optional<String> fault = Optional.empty();
    private int started; // how many missions were

    /**
     * For one run, which has not begun.
     */
    RunLifecycle(RunInput input, Session session, RunRecords records) {
        this.input = input;
        this.session = session;
        mission = records.mission();
        stall = new StallDetector(input.missions().size(), session, records);
    }

    /** What the recorder has heard happened in earlier processes: the mission may run already. */
    public void caughtUp() {
        started = mission.started();
    }

    /** Whether the first mission was started. */
    boolean hasStarted() {
        return started > 0;
    }

    /** Starts the first mission, once, if all its boats have joined. */
    public void startWhenAllHaveJoined() {
        if (started == 0 && mission.boatsJoined() >= input.settings().fleet().boats()) {
            start(input.missions().get(0));
        }
    }

    /** Starts those whose time has come since the first has started. */
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

    /** Whether and how it is over; asked again and again. */
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

    /** Ends the run for a fault; the first one counts. */
    public void fail(String reason) {
        if (fault.isEmpty()) {
            fault = Optional.of(reason);
        }
    }

    /** Why the run failed, in one sentence; empty as long as it did not. */
    public Optional<String> fault() {
        return fault;
    }

    /**
     * Looks whether anything can happen any longer; the run fails where nothing can. Looks a little later, when the fleet's thread has
     * reported which boats have commands: on a busy machine a new command may not have reached them yet.
     *
     * @param boats as they are then
     */
    public void lookForStall(Supplier<List<BoatState>> boats) {
        session.boatsWithWork(wanted -> lookForStall(boats.get(), wanted));
    }

    private void lookForStall(List<BoatState> boats, Set<String> wanted) {
        if (session.isComputing()) {
            return; // what boats are to do is still to come
        }
        long now = session.scheduler().nowMs();
        if (!input.settings().isConnected()) {
            stall.look(now, boats, wanted::contains).ifPresent(this::fail);
        } else if (wanted.stream()
                .noneMatch(boat -> canMove(boat, boats))) { // else a link or its operator may come back
            stall.look(now, boats, boat -> false).ifPresent(this::fail);
        }
    }

    private static boolean canMove(String boat, List<BoatState> boats) {
        return boats.stream().noneMatch(one -> one.id().equals(boat) && one.batteryPercent() <= 0);
    }
}
