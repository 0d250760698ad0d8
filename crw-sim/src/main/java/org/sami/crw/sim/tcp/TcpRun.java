package org.sami.crw.sim.tcp;

import java.io.IOException;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import org.sami.boat.link.LostLinkAction;
import org.sami.crw.decision.AnswersFile;
import org.sami.crw.handler.planning.CrwServices;
import org.sami.crw.proxy.explanation.LostLinkWords;
import org.sami.crw.proxy.link.ProxyConfig;
import org.sami.crw.proxy.tcp.BoatAddress;
import org.sami.crw.proxy.tcp.TcpBaseConfig;
import org.sami.crw.report.RunReport;
import org.sami.crw.session.Session;
import org.sami.crw.session.SessionDefaults;
import org.sami.crw.session.SessionRuntime;
import org.sami.crw.session.SessionSetup;
import org.sami.crw.session.fault.FaultPolicy;
import org.sami.crw.sim.boat.SimulatedBoatsOnTcp;
import org.sami.crw.sim.fleet.SimulatedFleet;
import org.sami.crw.sim.resume.ConnectedJournal;
import org.sami.crw.sim.run.RunHarness;
import org.sami.crw.sim.run.RunObserver;
import org.sami.crw.sim.run.record.RunNotes;
import org.sami.crw.sim.run.settings.RunInput;
import org.sami.crw.sim.run.settings.RunPlan;
import org.sami.crw.sim.run.settings.RunSettings;
import org.sami.crw.sim.run.settings.Site;
import org.sami.session.api.RefusedException;
import org.sami.session.record.SessionPictures;
import org.sami.spn.host.HostListener;
import org.sami.spn.value.GeoPoint;

/**
 * One mission on boats that are other processes, maybe with simulated ones of this process beside them, in real time: a client of a session. Three threads: the engine's and the fleet's,
 * which are the session's, and the caller's, which shows progress and what the operator must know at once. Used once.
 */
public final class TcpRun {
    private final RunInput input;
    private final RunSettings settings;
    private final ConnectedJournal journal;
    private final RunProcess process;
    private final Consumer<String> lines;
    private final CallerThread caller;
    private final RunNotes notes;
    private Optional<SessionPictures> pictures = Optional.empty();
    private Optional<LostLinkAction> lostLink = Optional.empty();

    /**
     * Puts a run together; nothing happens yet.
     *
     * @param answers the rules of the simulated operator's answers
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
        input = RunInput.of(plan, settings, answers);
        this.settings = settings;
        this.journal = journal;
        this.process = process;
        this.lines = lines;
        caller = new CallerThread(lines);
        notes = new RunNotes(caller::later);
    }

    /** Pictures go there where the run has no journal, next to which they are kept otherwise. Call it before the run. */
    public TcpRun keepPicturesIn(Optional<SessionPictures> folder) {
        pictures = folder;
        return this;
    }

    /** What boats are to do when their link is lost: each is set before it is sent anywhere, and a line says whether it has confirmed it. Call it before the run. */
    public TcpRun setLostLink(Optional<LostLinkAction> wish) {
        lostLink = wish;
        return this;
    }

    /**
     * Runs it to its end, to the set time, or until somebody wants it to stop. The boats are stopped before this returns, as far as
     * their links stand. An interrupt of the caller's thread makes it look at once whether it is to stop, and is kept.
     *
     * @throws BoatsNotReadyException if boats do not answer at the start
     * @throws UnfitRobotsException if all that answer are of another kind than the plan commands
     * @throws IOException if the journal cannot be read
     */
    public RunReport run(RunObserver observer) throws IOException {
        long beganNanos = System.nanoTime();
        try (Session session = Session.open(setup())) {
            session.addListener(notes);
            EarlierRun earlier =
                    new EarlierRun(journal.session().earlier(), session.fleet().history(), notes.fold());
            earlier.leftOut().ifPresent(lines);
            Optional<List<String>> startedWith = journal.startedWith();
            findArea(session, earlier, startedWith);
            Optional<Prepared> known = Optional.empty();
            if (earlier.area().isPresent()) {
                known = Optional.of(prepare(session, earlier.area().get()));
                known.get().catchUp(session, earlier, journal.cameToMillis());
                Optional<RunReport> told = known.get().harness.reportIfOver(journal.resumedFrom());
                if (told.isPresent()) {
                    return told.get();
                }
            }
            earlier.area()
                    .map(RunArea::boats)
                    .or(() -> startedWith)
                    .ifPresent(boats -> boats.forEach(session.fleet()::expect));
            List<String> again = reachBoatsOfPlans(session);
            launch(session, again);
            FleetReadiness readiness =
                    new FleetReadiness(session.fleet(), settings.connect(), settings.simulatedBesides());
            boolean ready = awaitBoats(readiness, startedWith.isPresent());
            Prepared run = known.isPresent()
                    ? known.get()
                    : prepare(session, found(session, startedWith.orElseGet(readiness::boats), ready));
            if (known.isEmpty() && startedWith.isPresent()) {
                run.catchUp(session, earlier, journal.cameToMillis());
            }
            if (ready) {
                lostLink.ifPresent(wish -> run.fleet.names().forEach(boat -> setLostLink(session, boat, wish)));
                run.fleet.areThere();
            }
            return run.harness.run(observer, beganNanos, journal::resumedFrom);
        } finally {
            caller.restoreInterrupt();
        }
    }

    private void setLostLink(Session session, String boat, LostLinkAction wish) {
        session.fleet()
                .setLostLinkAction(boat, wish)
                .whenComplete((taken, fault) -> caller.later(
                        fault == null
                                ? "without a link " + boat + " " + LostLinkWords.of(wish) + ", as it has confirmed"
                                : boat + " is not set for a lost link: " + RefusedException.reason(fault)));
    }

    /** A harness and the fleet that it runs on. */
    private record Prepared(RunHarness harness, ConnectedFleet fleet) {
        /** Takes in what happened in earlier processes; before anything happens in this one. */
        void catchUp(Session session, EarlierRun earlier, long cameToMillis) throws IOException {
            session.replay((index, atMillis, input, effects, view) -> {
                harness.clock().advanceTo(atMillis);
                for (HostListener listener : harness.records().listeners()) {
                    listener.onStep(index, atMillis, input, effects, view);
                }
            });
            harness.clock().advanceTo(cameToMillis);
            earlier.feed(harness.records().folds(), fleet.boatsOfReport());
            harness.lifecycle().caughtUp();
        }
    }

    private Prepared prepare(Session session, RunArea area) throws UnknownBoatException {
        ConnectedFleet fleet = new ConnectedFleet(settings, session, area, notes, caller);
        try {
            return new Prepared(new RunHarness(input, session, fleet, notes), fleet);
        } catch (IllegalArgumentException e) {
            throw new UnknownBoatException(String.valueOf(e.getMessage()));
        }
    }

    /**
     * Boats to which plans had connected in an earlier process, and those that it simulated, which are launched again where they were last. Those of
     * the run's own addresses may listen elsewhere by now. Gives the names of all that the journal knows.
     */
    private List<String> reachBoatsOfPlans(Session session) throws IOException {
        if (journal.resumedFrom().isEmpty()) {
            return List.of();
        }
        Set<BoatAddress> own = new HashSet<>(settings.connect());
        own.addAll(journal.record().settings().connect());
        return session.earlierBoats().reconnect(own);
    }

    /** Launches the simulated boats of this process, each at its berth, without those that are launched already. */
    private void launch(Session session, List<String> already) {
        List<String> names = settings.simulatedBesides();
        List<GeoPoint> berths = settings.fleet().berths(names.size(), SimulatedFleet.SPACING_M);
        for (int i = 0; i < names.size(); i++) {
            if (!already.contains(names.get(i))) {
                session.fleet()
                        .addSimulated(names.get(i), berths.get(i), 1)
                        .toCompletableFuture()
                        .join();
            }
        }
    }

    private SessionSetup setup() {
        ProxyConfig proxy =
                ProxyConfig.DEFAULT.withClientId(process.clientId()).withTelemetryHz(SessionDefaults.TELEMETRY_HZ);
        SessionRuntime runtime = new SessionRuntime.RealTime(
                process.clock(),
                TcpBaseConfig.of(proxy, settings.fleet().seed()),
                Optional.empty(),
                settings.simulatedBesides().isEmpty() ? Optional.empty() : Optional.of(simulated()));
        CrwServices services = CrwServices.STANDARD.drivenWith(
                settings.fleet().inProcess().conditions().crossTrackError());
        return new SessionSetup(
                input.plan().vocabulary(),
                input.plan().project(),
                journal.session(),
                services,
                runtime,
                FaultPolicy.ALONE,
                journal.session().file().isPresent() ? Optional.empty() : pictures);
    }

    private SimulatedBoatsOnTcp simulated() {
        return new SimulatedBoatsOnTcp(
                settings.fleet().seed(),
                settings.fleet().inProcess().conditions(),
                settings.fleet().robots());
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

    /** The area lies at the given place, else around the boats. */
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
    private boolean awaitBoats(FleetReadiness readiness, boolean underWay)
            throws BoatsNotReadyException, UnfitRobotsException {
        try {
            List<String> missing = readiness.await(process.clock(), process.connectWithinMillis());
            if (!missing.isEmpty()
                    && (!underWay || missing.size() == settings.fleet().boats())) {
                throw new BoatsNotReadyException(missing, process.connectWithinMillis());
            }
            List<String> unfit = readiness.unfit();
            if (!underWay
                    && !unfit.isEmpty()
                    && unfit.size() == readiness.boats().size()) {
                throw new UnfitRobotsException(unfit);
            }
            missing.forEach(boat -> lines.accept(boat + "; the mission goes on without it until it is there"));
            return true;
        } catch (InterruptedException e) {
            caller.interrupted();
            return false;
        } finally {
            caller.show();
        }
    }
}
