package org.sami.crw.session;

import java.io.Closeable;
import java.io.IOException;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import java.util.Optional;
import org.sami.crw.fleet.RobotKind;
import org.sami.crw.handler.HandlerModules;
import org.sami.crw.operator.OperatorModels;
import org.sami.crw.session.archive.MapHistory;
import org.sami.crw.session.archive.SessionJournal;
import org.sami.crw.session.fault.ThreadGuard;
import org.sami.session.record.OperatorLogRows;
import org.sami.session.record.SessionTelemetry;
import org.sami.spn.host.HostListener;
import org.sami.spn.journal.TelemetryRow;

/**
 * The parts of a session. Each is constructed from those before it and does by itself what belongs to its construction; they are closed in the reverse
 * order, the journal last.
 */
final class SessionParts {
    private final Deque<Closeable> made = new ArrayDeque<>();
    private final SessionJournal journal;
    private final SessionLooks looks;
    private final ThreadGuard guard;
    final SessionThreads threads;
    final SessionEngine engine;
    final SessionTelemetry telemetry;
    final OperatorModels models;
    final LostLinkWish lostLinkWish;
    final SessionMessages messages;
    final SessionFleet fleet;
    final SessionDomain domain;
    final SessionFaults faults;

    /** What the session's plans command. */
    final RobotKind robots;

    SessionParts(SessionSetup setup) throws IOException {
        journal = toClose(setup.journal());
        guard = new ThreadGuard(
                fault -> models().health().report(fault),
                reason -> engine().host().fail(reason));
        threads = toClose(new SessionThreads(setup.runtime(), journal.cameToMillis(), guard));
        engine = toClose(new SessionEngine(setup, threads));
        telemetry = new SessionTelemetry(journal::addTelemetry, threads::nowMs);
        robots = HandlerModules.robotsOf(setup.vocabulary());
        models = new OperatorModels(threads.front(), threads::nowMs, threads.drawing(), robots);
        if (!threads.isRealTime()) {
            models.showBoatsWhenAsked();
        }
        lostLinkWish = new LostLinkWish(journal, telemetry, threads::nowMs, models.log());
        messages = new SessionMessages(telemetry, models, robots);
        fleet = toClose(new SessionFleet(setup, threads, engine, telemetry, models, messages, robots, guard));
        if (threads
                .isRealTime()) { // a run in process is resumed by running its world again, with all that was done in it
            keepLog();
        }
        domain = toClose(new SessionDomain(setup, threads, engine, fleet, messages, guard));
        engine.listen(models);
        if (threads.isRealTime()) { // robots in process can do what plans ask
            listenForMissing();
        }
        Optional<SessionMonitor> monitor = threads.isRealTime()
                ? Optional.of(toClose(new SessionMonitor(
                        engine.host(), journal, fleet.connector(), models.health(), messages, setup.onFault(), guard)))
                : Optional.empty();
        faults = new SessionFaults(
                engine.host(),
                guard,
                monitor.map(SessionMonitor::engine),
                setup.onFault().boats());
        fleet.events().subscribe(models.fleetListener(fleet.connector().boats(), threads.showMillis()));
        models.onOperatingArea(area -> fleet.connector().keepTo(area, robots));
        looks = new SessionLooks(setup.vocabulary(), threads, engine, fleet, domain, models, monitor);
    }

    private <P extends Closeable> P toClose(P part) {
        made.push(part);
        return part;
    }

    private OperatorModels models() {
        return models;
    }

    private SessionEngine engine() {
        return engine;
    }

    private void listenForMissing() {
        FleetConnector connector = fleet.connector();
        CapabilityWatch missing =
                new CapabilityWatch(robots, connector::boats, connector.executor(), messages, threads.scheduler());
        engine.host().addListener(missing);
        fleet.events().subscribe(missing::take);
    }

    /** Restores the operator's log, the wish and the map from earlier processes, and keeps the log from now on. */
    private void keepLog() throws IOException {
        List<TelemetryRow> earlier = journal.earlier();
        models.log().restore(OperatorLogRows.read(earlier));
        lostLinkWish.restore(earlier);
        MapHistory.restore(earlier, models.map());
        fleet.pictures().ifPresent(kept -> kept.restore(earlier, models.pictures(), fleet.connector()));
        models.log()
                .keepWith(entry -> fleet.connector()
                        .executor()
                        .execute(() -> telemetry.add(
                                entry.atMillis(), "", OperatorLogRows.KIND, OperatorLogRows.json(entry))));
    }

    /** Replays the events of earlier processes to a listener, the models and the operators. */
    void replay(HostListener listener) throws IOException {
        engine.replay(listener, models);
    }

    void begin() {
        engine.begin(models, threads.nowMs());
        looks.begin();
        threads.start();
        journal.begun();
    }

    void close() throws IOException {
        fleet.listenNoLonger();
        threads.halt();
        for (Closeable part : made) { // the last that was made first
            part.close();
        }
    }
}
