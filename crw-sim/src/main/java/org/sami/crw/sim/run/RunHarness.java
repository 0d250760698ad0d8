package org.sami.crw.sim.run;

import java.util.Optional;
import java.util.OptionalLong;
import java.util.function.Supplier;
import org.sami.crw.decision.SimulatedOperator;
import org.sami.crw.report.RunOutcome;
import org.sami.crw.report.RunReport;
import org.sami.crw.session.Session;
import org.sami.crw.sim.clock.CatchUpScheduler;
import org.sami.crw.sim.run.operator.InterruptScheduler;
import org.sami.crw.sim.run.operator.SimulatedOperatorDriver;
import org.sami.crw.sim.run.record.ReportEnd;
import org.sami.crw.sim.run.record.RunNotes;
import org.sami.crw.sim.run.record.RunProgress;
import org.sami.crw.sim.run.record.RunRecords;
import org.sami.crw.sim.run.settings.RunInput;
import org.sami.crw.sim.run.settings.RunPlan;

/**
 * One run on a fleet of either kind: starts the missions, lets the simulated operator answer and interrupts be pressed, feeds the report and
 * determines when and how the run is over. The fleet says how time passes. Used once; for the engine's thread, unless stated otherwise.
 */
public final class RunHarness implements FleetRun {
    private static final long POLL_MILLIS = 200;
    private static final long TRACK_MILLIS = 1000;
    private static final long STALL_MILLIS = 1000;

    private final Session session;
    private final RunFleet fleet;
    private final CatchUpScheduler clock = new CatchUpScheduler();
    private final SimulatedOperatorDriver operator;
    private final InterruptScheduler interrupts;
    private final RunRecords records;
    private final RunLifecycle lifecycle;

    /**
     * A run on a session in which nothing has happened in this process.
     *
     * @param notes hear the session from its beginning
     * @throws IllegalArgumentException naming the interrupt, if one does not fit the plan or the boats
     */
    public RunHarness(RunInput input, Session session, RunFleet fleet, RunNotes notes) {
        this.session = session;
        this.fleet = fleet;
        RunPlan plan = input.plan();
        operator = new SimulatedOperatorDriver(
                new SimulatedOperator(plan.vocabulary(), fleet.operatorDefaults(), input.answers()),
                clock,
                input.settings().answerAfterMillis(),
                fleet.operatorDefaults().quay());
        interrupts =
                new InterruptScheduler(input.interrupts().read(input.settings().interrupts(), fleet.names()), clock);
        records = new RunRecords(input, session, fleet.plane(), notes, operator, interrupts);
        fleet.addTo(records.folds());
        lifecycle = new RunLifecycle(input, fleet.names().size(), session, records);
        session.addOperator(operator);
    }

    @Override
    public RunRecords records() {
        return records;
    }

    @Override
    public RunLifecycle lifecycle() {
        return lifecycle;
    }

    /** The clock of operator and interrupts: shows the time of earlier processes until {@link #connect}. */
    public CatchUpScheduler clock() {
        return clock;
    }

    @Override
    public void connect() {
        records.listeners().forEach(session::addListener);
        clock.goLive(session.scheduler());
        operator.connect(session);
        interrupts.connect(session.host());
    }

    @Override
    public void followBoats(Runnable afterLook) {
        repeat(POLL_MILLIS, () -> {
            fleet.lookForVisits(now());
            afterLook.run();
        });
        repeat(TRACK_MILLIS, () -> fleet.track(now()));
    }

    @Override
    public void lookForStalls() {
        repeat(STALL_MILLIS, () -> lifecycle.lookForStall(fleet::boats));
    }

    @Override
    public void repeat(long everyMillis, Runnable action) {
        action.run();
        session.scheduler().after(everyMillis, () -> repeat(everyMillis, action));
    }

    @Override
    public RunProgress progress(String phase) {
        return records.progress(phase);
    }

    private long now() {
        return session.scheduler().nowMs();
    }

    /**
     * Runs until the end, until the time limit or until the observer stops it, and reports. On the caller's thread.
     *
     * @param beganNanos when this process began with it, on the machine's monotonic clock
     * @param resumedFrom gives at the end the index of the last input that was taken from a journal
     */
    public RunReport run(RunObserver observer, long beganNanos, Supplier<OptionalLong> resumedFrom) {
        RunOutcome outcome;
        long endMillis;
        double wallSeconds;
        RunNews news = new RunNews(session.models(), session.scheduler()::nowMs, fleet.heard(observer.news()));
        try {
            outcome = fleet.live(this, observer);
            wallSeconds = (System.nanoTime() - beganNanos) / 1e9;
            endMillis = endMillis();
            fleet.leave(endMillis);
        } finally {
            news.close();
        }
        return report(outcome, endMillis, wallSeconds, resumedFrom.get());
    }

    /** The report of a run that was over in an earlier process; empty where it was not. */
    public Optional<RunReport> reportIfOver(OptionalLong resumedFrom) {
        return !records.mission().isOver()
                ? Optional.empty()
                : lifecycle.outcome().map(outcome -> report(outcome, endMillis(), 0, resumedFrom));
    }

    /** The end of the run in ms since its start; the present time if only this process ends. */
    private long endMillis() {
        return records.mission().endedAtMillis().orElseGet(this::now);
    }

    private RunReport report(RunOutcome outcome, long atMillis, double wallSeconds, OptionalLong resumedFrom) {
        String fault = lifecycle.fault().orElse("");
        String reason = outcome == RunOutcome.ENDED || fault.isEmpty() ? fault : fleet.reason(fault);
        fleet.awaitShown();
        return records.report(
                new ReportEnd(outcome, reason, atMillis, wallSeconds, resumedFrom, fleet.boats(), fleet::link));
    }
}
