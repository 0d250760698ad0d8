package org.sami.crw.sim.tcp;

import java.io.IOException;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import org.sami.crw.decision.AnswersFile;
import org.sami.crw.sim.report.RunOutcome;
import org.sami.crw.sim.report.RunReport;
import org.sami.crw.sim.run.Parameters;
import org.sami.crw.sim.run.RunObserver;
import org.sami.crw.sim.run.RunPlan;
import org.sami.crw.sim.run.RunSettings;
import org.sami.crw.sim.run.Site;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.Value;

/**
 * One mission on boats that are other processes, in real time. Three threads: the engine's, the links' (with proxies and
 * handlers), and the caller's, which shows progress and what the operator must know at once. Used once.
 */
public final class TcpRun {
    private static final long SHOW_MS = 50;

    private final RunPlan plan;
    private final RunSettings settings;
    private final Map<String, Value> parameters;
    private final AnswersFile answers;
    private final SessionJournal journal;
    private final SessionStart start;
    private final Consumer<String> lines;
    private boolean interrupted;

    /**
     * Puts a run together; nothing happens yet.
     *
     * @param answers what the simulated operator is told to answer
     * @param lines gets what the operator must know at once, on the caller's thread
     * @throws IllegalArgumentException naming the parameter, if a given one does not fit the plan
     */
    public TcpRun(
            RunPlan plan,
            RunSettings settings,
            AnswersFile answers,
            SessionJournal journal,
            SessionStart start,
            Consumer<String> lines) {
        this.plan = plan;
        this.settings = settings;
        this.answers = answers;
        this.journal = journal;
        this.start = start;
        this.lines = lines;
        parameters = new Parameters(plan.vocabulary(), plan.project(), plan.plan()).read(settings.parameters());
    }

    /**
     * Runs it to its end, to the set time, or until somebody wants it to stop. The boats are stopped before this returns, as far as
     * their links stand. An interrupt of the caller's thread makes it look at once whether it is to stop, and is kept.
     *
     * @throws BoatsNotReadyException if boats do not answer at the start
     * @throws IOException if the journal cannot be read
     */
    public RunReport run(RunObserver observer) throws IOException {
        long wallStart = System.nanoTime();
        try (TcpRuntime station = new TcpRuntime(plan, settings, journal, start)) {
            EarlierRun earlier = new EarlierRun(journal.earlier(), station.desk(), station.notices());
            earlier.leftOut().ifPresent(lines);
            Optional<List<String>> startedWith = journal.startedWith();
            findArea(station, earlier, startedWith);
            Optional<RunMonitor> known = Optional.empty();
            if (earlier.area().isPresent()) {
                known = Optional.of(watch(station, earlier.area().get()));
                known.get().catchUp(earlier);
                if (known.get().wasOver()) {
                    return known.get()
                            .report(
                                    known.get().outcome().orElseThrow(),
                                    known.get().endMillis(),
                                    0);
                }
            }
            station.notes().begun();
            station.desk().begunAnew();
            earlier.area()
                    .map(SessionArea::boats)
                    .or(() -> startedWith)
                    .ifPresent(boats -> boats.forEach(station.base()::expect));
            FleetReadiness roll =
                    new FleetReadiness(station.base(), settings.connect(), station.desk(), station.notes());
            boolean ready = callRoll(station, roll, startedWith.isPresent());
            RunMonitor watch;
            if (known.isPresent()) {
                watch = known.get();
            } else {
                watch = watch(station, found(station, startedWith.orElseGet(roll::boats), ready));
                if (startedWith.isPresent()) {
                    watch.catchUp(earlier);
                }
            }
            RunOutcome outcome = ready ? watched(station, watch, observer) : RunOutcome.RUNNING;
            long endMillis = watch.endMillis();
            station.leave();
            watch.noteEnd(endMillis);
            show(station);
            double wallSeconds = (System.nanoTime() - wallStart) / 1e9;
            return watch.report(outcome, endMillis, wallSeconds);
        } finally {
            if (interrupted) {
                Thread.currentThread().interrupt();
            }
        }
    }

    private RunMonitor watch(TcpRuntime station, SessionArea area) throws UnknownBoatException {
        return new RunMonitor(plan, settings, parameters, answers, journal, station, area);
    }

    /**
     * Looks for the area of a mission that an earlier process started: its telemetry may be damaged, but the engine remembers it; in a
     * journal of before it did, it lies around where the boats were first.
     */
    private void findArea(TcpRuntime station, EarlierRun earlier, Optional<List<String>> startedWith) {
        if (earlier.area().isPresent() || startedWith.isEmpty()) {
            return;
        }
        Optional<SessionArea> remembered = station.host().ask(SessionArea::remembered);
        List<GeoPoint> first = earlier.firstPositions();
        if (remembered.isPresent()) {
            lines.accept("telemetry: where the area lies is lost there, and taken from the engine's entries");
            earlier.know(remembered.get());
        } else if (!first.isEmpty()) {
            lines.accept("telemetry: where the area lies is lost; it is taken to be where the boats were first");
            earlier.know(area(first, startedWith.get()));
        } else if (station.host().ask(view -> view.missions().isEmpty())) {
            lines.accept("telemetry: where the area lies is lost, and where the boats were");
            earlier.know(area(first, startedWith.get()));
        } else {
            lines.accept("telemetry: where the area lies is lost; it is taken to be where the boats are now");
        }
    }

    /** The area lies where somebody said, else around the boats. */
    private SessionArea area(List<GeoPoint> positions, List<String> boats) {
        return settings.fleet()
                .site()
                .centre()
                .map(centre -> new SessionArea(centre, boats))
                .orElseGet(() -> SessionArea.around(positions, boats));
    }

    /** The area as it is found when the boats have answered. It stays there, whatever becomes of the run. */
    private SessionArea found(TcpRuntime station, List<String> boats, boolean ready) {
        SessionArea area = area(station.desk().positions(), boats);
        if (ready) {
            lines.accept("centre " + Site.words(area.centre()));
            station.notes().area(area);
            station.host().post(area.remember());
        }
        return area;
    }

    /** Returns whether the mission can begin or go on; not if somebody wants an end meanwhile. */
    private boolean callRoll(TcpRuntime station, FleetReadiness roll, boolean underWay) throws BoatsNotReadyException {
        try {
            List<String> missing = roll.await(start.clock(), start.connectWithinMillis());
            if (!missing.isEmpty()
                    && (!underWay || missing.size() == settings.connect().size())) {
                throw new BoatsNotReadyException(missing, start.connectWithinMillis());
            }
            missing.forEach(boat -> lines.accept(boat + "; the mission goes on without it until it is there"));
            return true;
        } catch (InterruptedException e) {
            interrupted = true;
            return false;
        } finally {
            show(station);
        }
    }

    private RunOutcome watched(TcpRuntime station, RunMonitor watch, RunObserver observer) {
        CountDownLatch over = new CountDownLatch(1);
        RunOutcome[] outcome = {RunOutcome.FAILED};
        Thread engine = new Thread(
                () -> {
                    try {
                        watch.begin();
                        station.loop().run(() -> watch.outcome().isPresent());
                        outcome[0] = watch.outcome().orElse(RunOutcome.RUNNING);
                    } catch (RuntimeException e) {
                        watch.fail("the run broke: " + e);
                    } finally {
                        over.countDown();
                    }
                },
                "engine");
        engine.setDaemon(true);
        engine.start();
        while (!isOver(over)) {
            show(station);
            observer.progress().accept(watch.latest());
            if (observer.stop().getAsBoolean()) {
                watch.stop();
            }
        }
        return outcome[0];
    }

    private boolean isOver(CountDownLatch over) {
        try {
            return over.await(SHOW_MS, TimeUnit.MILLISECONDS);
        } catch (InterruptedException e) {
            interrupted = true;
            return false;
        }
    }

    private void show(TcpRuntime station) {
        for (String line = station.notices().next();
                line != null;
                line = station.notices().next()) {
            lines.accept(line);
        }
    }
}
