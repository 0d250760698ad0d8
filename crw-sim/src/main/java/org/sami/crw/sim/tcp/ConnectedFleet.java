package org.sami.crw.sim.tcp;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.stream.Collectors;
import org.sami.boat.server.vehicle.LocalFrame;
import org.sami.crw.decision.DefaultAnswers;
import org.sami.crw.report.LinkResult;
import org.sami.crw.report.LocationResult;
import org.sami.crw.report.RunOutcome;
import org.sami.crw.session.BoatsAtEnd;
import org.sami.crw.session.Session;
import org.sami.crw.session.SessionListener;
import org.sami.crw.sim.run.FleetRun;
import org.sami.crw.sim.run.RunFleet;
import org.sami.crw.sim.run.RunObserver;
import org.sami.crw.sim.run.record.BoatState;
import org.sami.crw.sim.run.record.ReportFolds;
import org.sami.crw.sim.run.record.RunNotes;
import org.sami.crw.sim.run.record.RunProgress;
import org.sami.crw.sim.run.record.TrackRecorder;
import org.sami.crw.sim.run.settings.FleetSettings;
import org.sami.crw.sim.run.settings.RunSettings;
import org.sami.session.record.FleetHistory;
import org.sami.spn.value.GeoPoint;

/**
 * Boats that are other processes, in real time: known by their reports, which are written to the session's journal for the report of the run
 * again. The run lives on the session's threads while the caller waits.
 */
final class ConnectedFleet implements RunFleet {
    private static final long SHOW_MS = 50;

    /** How long the last pictures may take when the mission is over. */
    private static final long PICTURES_S = 20;

    private final RunSettings settings;
    private final Session session;
    private final RunArea area;
    private final RunNotes notes;
    private final CallerThread caller;
    private final LocalFrame plane;
    private final RunBoats boats;
    private final CountDownLatch over = new CountDownLatch(1);
    private Optional<ReportFolds> report = Optional.empty();
    private Map<String, FleetHistory.Report> reportedBefore = Map.of(); // a track period ago, by boat
    private Optional<RunOutcome> ended = Optional.empty();
    private boolean isThere;
    private volatile boolean stopAsked;
    private volatile Optional<RunProgress> progress = Optional.empty();

    /**
     * The boats of a session.
     *
     * @param area in which the locations lie, and the boats
     */
    ConnectedFleet(RunSettings settings, Session session, RunArea area, RunNotes notes, CallerThread caller) {
        this.settings = settings;
        this.session = session;
        this.area = area;
        this.notes = notes;
        this.caller = caller;
        plane = new LocalFrame(area.centre().latDeg(), area.centre().lonDeg());
        boats = new RunBoats(session.fleet().history(), plane);
        session.leavePosesToCaller(); // tracks are thinned first
    }

    /** The boats as the report has them. */
    RunBoats boatsOfReport() {
        return boats;
    }

    /** The boats are there: the mission can begin or go on. Without this nothing does. */
    void areThere() {
        isThere = true;
    }

    @Override
    public LocalFrame plane() {
        return plane;
    }

    @Override
    public DefaultAnswers operatorDefaults() {
        FleetSettings size = settings.fleet();
        return new DefaultAnswers(area.centre(), size.areaM(), size.locations(), size.seed());
    }

    @Override
    public List<String> names() {
        return area.boats();
    }

    @Override
    public List<BoatState> boats() {
        return boats.all();
    }

    @Override
    public LinkResult link(String boat) {
        return boats.link(boat);
    }

    @Override
    public void addTo(ReportFolds folds) {
        report = Optional.of(folds);
    }

    @Override
    public RunObserver.News heard(RunObserver.News news) {
        return new RunObserver.News(caller::later, news.isDetailed());
    }

    @Override
    public RunOutcome live(FleetRun run, RunObserver observer) {
        notes.leaveMessagesToNews(true);
        if (!isThere) {
            return RunOutcome.RUNNING;
        }
        begin(run);
        while (!caller.await(over, SHOW_MS)) {
            caller.show();
            progress.ifPresent(observer.progress());
            if (observer.stop().getAsBoolean()) {
                stopAsked = true;
                session.execute(() -> check(run));
            }
        }
        return ended.orElse(RunOutcome.FAILED);
    }

    /** From now on everything happens on the engine's thread. */
    private void begin(FleetRun run) {
        progress = Optional.of(run.progress(RunProgress.RUNNING));
        run.connect();
        session.addListener(listener(run));
        session.addListener((index, atMillis, input, effects, view) -> check(run));
        session.execute(() -> {
            run.followBoats(() -> {
                progress = Optional.of(run.progress(RunProgress.RUNNING));
                check(run);
            });
            run.lookForStalls();
        });
        session.scheduler().at(settings.stopMillis(), () -> check(run));
        session.begin();
    }

    private SessionListener listener(FleetRun run) {
        return new SessionListener() {
            @Override
            public void onPassed(String boat, List<GeoPoint> points, long atMillis) {
                session.execute(
                        () -> points.forEach(point -> report.orElseThrow().visit(boat, point, atMillis)));
            }

            @Override
            public void onBroken(String reason) {
                run.lifecycle().fail("the run broke: " + reason);
                over.countDown();
            }
        };
    }

    /** Ends the run where it is over, before anything else happens. */
    private void check(FleetRun run) {
        if (ended.isEmpty()) {
            run.lifecycle().startWhenAllHaveJoined();
            ended = run.lifecycle().outcome();
            if (ended.isEmpty() && (stopAsked || session.scheduler().nowMs() >= settings.stopMillis())) {
                ended = Optional.of(RunOutcome.RUNNING);
            }
            ended.ifPresent(how -> session.halt().thenRun(over::countDown));
        }
    }

    /** Records visits with the time of the report, so that the journal gives the same again. */
    @Override
    public void lookForVisits(long nowMillis) {
        for (LocationResult news : report.orElseThrow().visits().look(nowMillis, boats())) {
            String boat = news.reported().orElseThrow().boat();
            session.telemetry().visited(nowMillis, boat, GeoPoint.of(news.latDeg(), news.lonDeg()));
        }
    }

    @Override
    public void track(long nowMillis) {
        Map<String, FleetHistory.Report> now = new HashMap<>();
        List<BoatState> there = boats();
        FleetHistory history = session.fleet().history();
        there.forEach(boat -> history.last(boat.id()).ifPresent(reported -> now.put(boat.id(), reported)));
        for (TrackRecorder.Noted noted : report.orElseThrow().tracks().look(nowMillis, there)) {
            BoatState boat = noted.boat();
            FleetHistory.Report reported = (noted.atMillis() < nowMillis ? reportedBefore : now).get(boat.id());
            if (reported != null) {
                session.telemetry().pose(noted.atMillis(), boat.id(), reported, boat.distanceM());
            }
        }
        reportedBefore = now;
    }

    @Override
    public void leave(long endMillis) {
        session.leave(BoatsAtEnd.STOP, this::awaitPictures).forEach(caller::later);
        noteEnd(endMillis);
        notes.leaveMessagesToNews(false);
    }

    /** Those of the last panorama still come when the mission is over and the boats are stopped; nobody waits for them where the run was cut short. */
    private void awaitPictures() {
        if (!ended.equals(Optional.of(RunOutcome.ENDED))) {
            return;
        }
        try {
            session.picturesFetched().toCompletableFuture().get(PICTURES_S, TimeUnit.SECONDS);
        } catch (ExecutionException | TimeoutException late) {
            caller.later("not all pictures have come from the boats; they stay on board");
        } catch (InterruptedException e) {
            caller.interrupted();
        }
    }

    /** Writes down where the boats have come to lie, and why they moved or did not, so that the run can be reported again. */
    private void noteEnd(long atMillis) {
        for (BoatState boat : boats()) {
            session.telemetry().why(atMillis, boat.id(), link(boat.id()).why());
            session.fleet()
                    .history()
                    .last(boat.id())
                    .ifPresent(reported -> session.telemetry().pose(atMillis, boat.id(), reported, boat.distanceM()));
        }
        session.telemetry().flush();
    }

    @Override
    public void awaitShown() {
        caller.show();
        session.models().shown().toCompletableFuture().join();
    }

    @Override
    public String reason(String fault) {
        return fault
                + boats().stream().map(boat -> "; " + link(boat.id()).why()).collect(Collectors.joining());
    }
}
