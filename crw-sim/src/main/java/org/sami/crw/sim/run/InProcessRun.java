package org.sami.crw.sim.run;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import org.sami.crw.decision.AnswersFile;
import org.sami.crw.handler.planning.CrwServices;
import org.sami.crw.operator.OperatorModels;
import org.sami.crw.report.RunReport;
import org.sami.crw.session.Session;
import org.sami.crw.session.SessionRuntime;
import org.sami.crw.session.SessionSetup;
import org.sami.crw.session.archive.SessionJournal;
import org.sami.crw.session.fault.FaultPolicy;
import org.sami.crw.sim.clock.VirtualClock;
import org.sami.crw.sim.run.record.RunNotes;
import org.sami.crw.sim.run.settings.RunInput;
import org.sami.crw.sim.run.settings.RunPlan;
import org.sami.crw.sim.run.settings.RunSettings;
import org.sami.crw.sim.run.world.SimulatedBoatConnector;
import org.sami.crw.sim.run.world.SimulatedWater;
import org.sami.session.record.SessionPictures;
import org.sami.spn.engine.EngineView;
import org.sami.spn.host.EngineHost;
import org.sami.spn.host.HostListener;

/**
 * One mission on simulated boats, all in one thread: engine, handlers, links, boats and operator; helper threads tick the boats of large fleets
 * (docs/threads.md). The result is a function of plan and settings; speed and helpers change only how long the run takes. Used once, by one
 * thread.
 */
public final class InProcessRun {
    private static final int BOATS_FOR_HELPERS = 50; // a smaller fleet is ticked before a helper has woken up
    private static final int MOST_HELPERS = 3;

    private final RunSettings settings;
    private final RunJournal journal;
    private final LoopExecutor executor = new LoopExecutor();
    private final VirtualClock clock = new VirtualClock();
    private final SimulatedWater water;
    private final Session session;
    private final InProcessFleet fleet;
    private final RunHarness harness;

    /**
     * Puts the world together; nothing has happened in it yet.
     *
     * @param answers the rules of the simulated operator's answers
     * @throws IllegalArgumentException naming the parameter or the interrupt, if a given one does not fit the plan
     */
    public InProcessRun(RunPlan plan, RunSettings settings, AnswersFile answers, RunJournal journal) {
        this(plan, settings, answers, journal, Optional.empty());
    }

    /**
     * The same with the pictures that boats take.
     *
     * @param pictures where they are kept; empty = none is drawn
     */
    public InProcessRun(
            RunPlan plan,
            RunSettings settings,
            AnswersFile answers,
            RunJournal journal,
            Optional<SessionPictures> pictures) {
        this.settings = settings;
        this.journal = journal;
        RunInput input = RunInput.of(plan, settings, answers);
        SimulatedBoatConnector connector = new SimulatedBoatConnector(executor);
        session = open(plan, settings, journal, new SessionRuntime.OneThread(clock, executor, connector), pictures);
        RunNotes notes = new RunNotes(line -> {});
        session.addListener(notes);
        water = new SimulatedWater(clock, settings.fleet(), connector::listenerOf);
        connector.launch(water);
        fleet = new InProcessFleet(settings, journal, executor, clock, water, session);
        harness = new RunHarness(input, session, fleet, notes);
        harness.connect();
    }

    private static Session open(
            RunPlan plan,
            RunSettings settings,
            RunJournal journal,
            SessionRuntime world,
            Optional<SessionPictures> pictures) {
        try {
            return Session.open(new SessionSetup(
                    plan.vocabulary(),
                    plan.project(),
                    SessionJournal.over(journal.inputs()),
                    CrwServices.STANDARD.drivenWith(
                            settings.fleet().inProcess().conditions().crossTrackError()),
                    world,
                    FaultPolicy.ATTENDED,
                    pictures));
        } catch (IOException noFile) {
            throw new UncheckedIOException(noFile); // it reads none
        }
    }

    /**
     * Runs until its end, until the time limit, or until the observer stops it.
     *
     * @param pacer keeps its time; not asked while the run only catches up with its journal
     */
    public RunReport run(Pacer pacer, RunObserver observer) {
        long beganNanos = System.nanoTime();
        fleet.pacedBy(pacer);
        return harness.run(observer, beganNanos, journal::resumedFrom);
    }

    /** The session on which it runs, for a window that shows it; on the run's thread. */
    public Session session() {
        return session;
    }

    /** The run goes on until its time limit even if nothing can happen in the mission any longer. Call it before the run. */
    public void goOnWhenStuck() {
        fleet.goOnWhenStuck();
    }

    /**
     * Ticks the boats of large fleets on all cores of the machine: for callers that make one run at a time. Changes only how long a run takes. Call
     * it before the run.
     */
    public void useAllCores() {
        boolean isWorthIt = settings.speed().isMax() && settings.fleet().boats() >= BOATS_FOR_HELPERS;
        useHelpers(isWorthIt ? Math.min(MOST_HELPERS, Runtime.getRuntime().availableProcessors() - 1) : 0);
    }

    /** Sets the number of threads that help to tick the boats. Call it before the run. */
    void useHelpers(int count) {
        fleet.useHelpers(count);
    }

    /** Adds a listener to the engine. Call it before the run. */
    public void addListener(HostListener listener) {
        session.addListener(listener);
    }

    /** Reads the engine's state, between or after runs. */
    public <T> T ask(Function<EngineView, T> question) {
        return session.host().ask(question);
    }

    /** Decisions that the simulated operator could not answer, in words, oldest first. */
    public List<String> operatorTroubles() {
        return harness.records().operator().troubles();
    }

    /** The boats and their time, for tests. */
    SimulatedWater water() {
        return water;
    }

    /** The engine's host, for tests. */
    EngineHost host() {
        return session.host();
    }

    /** The models of this run's operator, for tests. */
    OperatorModels models() {
        return session.models();
    }

    /** Continues the world without the mission, for so many milliseconds: shows what boats do afterwards. */
    public void coast(long millis) {
        long until = clock.nowMs() + millis;
        for (long next = clock.nowMs(); next <= until; next = clock.nextTimeMs().orElse(Long.MAX_VALUE)) {
            executor.drain();
            clock.runNext();
        }
        executor.drain();
    }
}
