package org.sami.crw.sim.tcp;

import java.io.IOException;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Queue;
import java.util.Set;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.function.Consumer;
import org.sami.crw.decision.AnswersFile;
import org.sami.crw.handler.planning.CrwServices;
import org.sami.crw.proxy.link.ProxyConfig;
import org.sami.crw.proxy.tcp.BoatAddress;
import org.sami.crw.proxy.tcp.TcpBaseConfig;
import org.sami.crw.session.Session;
import org.sami.crw.session.SessionRuntime;
import org.sami.crw.session.SessionSetup;
import org.sami.crw.session.fault.FaultPolicy;
import org.sami.crw.sim.report.RunOutcome;
import org.sami.crw.sim.report.RunReport;
import org.sami.crw.sim.resume.ConnectedJournal;
import org.sami.crw.sim.run.RunNews;
import org.sami.crw.sim.run.RunObserver;
import org.sami.crw.sim.run.record.RunNotes;
import org.sami.crw.sim.run.settings.Parameters;
import org.sami.crw.sim.run.settings.RunPlan;
import org.sami.crw.sim.run.settings.RunSettings;
import org.sami.crw.sim.run.settings.Site;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.Value;

/**
 * One mission on boats that are other processes, in real time: a client of a session. Three threads: the engine's and the fleet's,
 * which are the session's, and the caller's, which shows progress and what the operator must know at once. Used once.
 */
public final class TcpRun {
    private static final long SHOW_MS = 50;

    private final RunPlan plan;
    private final RunSettings settings;
    private final Map<String, Value> parameters;
    private final AnswersFile answers;
    private final ConnectedJournal journal;
    private final RunProcess process;
    private final Consumer<String> lines;
    private final Queue<String> toShow = new ConcurrentLinkedQueue<>();
    private final RunNotes notes = new RunNotes(toShow::add);
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
            ConnectedJournal journal,
            RunProcess process,
            Consumer<String> lines) {
        this.plan = plan;
        this.settings = settings;
        this.answers = answers;
        this.journal = journal;
        this.process = process;
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
        try (Session session = Session.open(setup())) {
            session.addListener(notes);
            EarlierRun earlier =
                    new EarlierRun(journal.session().earlier(), session.fleet().history(), notes.fold());
            earlier.leftOut().ifPresent(lines);
            Optional<List<String>> startedWith = journal.startedWith();
            findArea(session, earlier, startedWith);
            Optional<RunMonitor> known = Optional.empty();
            if (earlier.area().isPresent()) {
                known = Optional.of(watch(session, earlier.area().get()));
                known.get().catchUp(earlier);
                if (known.get().wasOver()) {
                    return known.get()
                            .report(
                                    known.get().outcome().orElseThrow(),
                                    known.get().endMillis(),
                                    0);
                }
            }
            earlier.area()
                    .map(RunArea::boats)
                    .or(() -> startedWith)
                    .ifPresent(boats -> boats.forEach(session.fleet()::expect));
            reachBoatsOfPlans(session);
            FleetReadiness readiness = new FleetReadiness(session.fleet(), settings.connect());
            boolean ready = awaitBoats(readiness, startedWith.isPresent());
            RunMonitor watch;
            if (known.isPresent()) {
                watch = known.get();
            } else {
                watch = watch(session, found(session, startedWith.orElseGet(readiness::boats), ready));
                if (startedWith.isPresent()) {
                    watch.catchUp(earlier);
                }
            }
            RunObserver.News news =
                    new RunObserver.News(toShow::add, observer.news().isDetailed());
            RunOutcome outcome;
            long endMillis;
            RunNews told = new RunNews(session.models(), session.scheduler()::nowMs, news);
            notes.leaveMessagesToNews(true);
            try {
                outcome = ready ? watched(watch, observer) : RunOutcome.RUNNING;
                endMillis = watch.endMillis();
                toShow.addAll(session.leave());
                watch.noteEnd(endMillis);
            } finally {
                notes.leaveMessagesToNews(false);
                told.close();
            }
            show();
            double wallSeconds = (System.nanoTime() - wallStart) / 1e9;
            return watch.report(outcome, endMillis, wallSeconds);
        } finally {
            if (interrupted) {
                Thread.currentThread().interrupt();
            }
        }
    }

    /** Boats to which plans had connected in an earlier process. Those of the run's own addresses may listen elsewhere by now. */
    private void reachBoatsOfPlans(Session session) throws IOException {
        if (journal.resumedFrom().isPresent()) {
            Set<BoatAddress> own = new HashSet<>(settings.connect());
            own.addAll(journal.record().settings().connect());
            session.reconnect(own);
        }
    }

    private SessionSetup setup() {
        ProxyConfig proxy = ProxyConfig.DEFAULT
                .withClientId(process.clientId())
                .withTelemetryHz(SessionRuntime.RealTime.TELEMETRY_HZ);
        SessionRuntime runtime = new SessionRuntime.RealTime(
                process.clock(), TcpBaseConfig.of(proxy, settings.fleet().seed()), Optional.empty(), Optional.empty());
        CrwServices services =
                CrwServices.STANDARD.drivenWith(settings.fleet().conditions().crossTrackError());
        return new SessionSetup(
                plan.vocabulary(), plan.project(), journal.session(), services, runtime, FaultPolicy.ALONE);
    }

    private RunMonitor watch(Session session, RunArea area) throws UnknownBoatException {
        return new RunMonitor(plan, settings, parameters, answers, journal, session, notes, area);
    }

    /**
     * Looks for the area of a mission that an earlier process started: its telemetry may be damaged, but the engine remembers it; in a
     * journal of before it did, it lies around where the boats were first.
     */
    private void findArea(Session session, EarlierRun earlier, Optional<List<String>> startedWith) {
        if (earlier.area().isPresent() || startedWith.isEmpty()) {
            return;
        }
        Optional<RunArea> remembered = session.host().ask(RunArea::remembered);
        List<GeoPoint> first = earlier.firstPositions();
        if (remembered.isPresent()) {
            lines.accept("telemetry: where the area lies is lost there, and taken from the engine's entries");
            earlier.know(remembered.get());
        } else if (!first.isEmpty()) {
            lines.accept("telemetry: where the area lies is lost; it is taken to be where the boats were first");
            earlier.know(area(first, startedWith.get()));
        } else if (session.host().ask(view -> view.missions().isEmpty())) {
            lines.accept("telemetry: where the area lies is lost, and where the boats were");
            earlier.know(area(first, startedWith.get()));
        } else {
            lines.accept("telemetry: where the area lies is lost; it is taken to be where the boats are now");
        }
    }

    /** The area lies where somebody said, else around the boats. */
    private RunArea area(List<GeoPoint> positions, List<String> boats) {
        return settings.fleet()
                .site()
                .centre()
                .map(centre -> new RunArea(centre, boats))
                .orElseGet(() -> RunArea.around(positions, boats));
    }

    /** The area as it is found when the boats have answered. It stays there, whatever becomes of the run. */
    private RunArea found(Session session, List<String> boats, boolean ready) {
        RunArea area = area(session.fleet().history().positions(), boats);
        if (ready) {
            lines.accept("centre " + Site.words(area.centre()));
            area.note(session.telemetry(), session.scheduler().nowMs());
            session.host().post(area.remember());
        }
        return area;
    }

    /** Returns whether the mission can begin or go on; not if somebody wants an end meanwhile. */
    private boolean awaitBoats(FleetReadiness readiness, boolean underWay) throws BoatsNotReadyException {
        try {
            List<String> missing = readiness.await(process.clock(), process.connectWithinMillis());
            if (!missing.isEmpty()
                    && (!underWay || missing.size() == settings.connect().size())) {
                throw new BoatsNotReadyException(missing, process.connectWithinMillis());
            }
            missing.forEach(boat -> lines.accept(boat + "; the mission goes on without it until it is there"));
            return true;
        } catch (InterruptedException e) {
            interrupted = true;
            return false;
        } finally {
            show();
        }
    }

    private RunOutcome watched(RunMonitor watch, RunObserver observer) {
        watch.begin();
        while (!isOver(watch)) {
            show();
            observer.progress().accept(watch.latest());
            if (observer.stop().getAsBoolean()) {
                watch.stop();
            }
        }
        return watch.ended();
    }

    private boolean isOver(RunMonitor watch) {
        try {
            return watch.awaitEnd(SHOW_MS);
        } catch (InterruptedException e) {
            interrupted = true;
            return false;
        }
    }

    private void show() {
        for (String line = toShow.poll(); line != null; line = toShow.poll()) {
            lines.accept(line);
        }
    }
}
