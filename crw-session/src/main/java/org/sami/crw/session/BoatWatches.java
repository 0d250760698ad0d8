package org.sami.crw.session;

import java.util.Optional;
import java.util.function.LongSupplier;
import org.sami.crw.fleet.FleetEvent;
import org.sami.crw.operator.OperatorModels;
import org.sami.crw.session.archive.BoatLog;
import org.sami.crw.session.archive.PoseLog;
import org.sami.session.record.FleetHistory;
import org.sami.session.record.SessionTelemetry;

/** What looks at the boats of a session every second, and what writes down what they do. For the fleet's thread, but where said. */
final class BoatWatches {
    private final FleetConnector connector;
    private final LongSupplier nowMillis;
    private final boolean keepsTelemetry;
    private final BoatMonitor monitor;
    private final LinkWatch links;
    private final UnreachedWatch unreached;
    private final PoseLog poses;
    private final BoatLog log;
    private volatile boolean closed;

    /**
     * Watches of the boats of one connector.
     *
     * @param remembered the boats that later processes find again
     */
    BoatWatches(
            SessionSetup setup,
            FleetConnector connector,
            FleetHistory history,
            Optional<RememberedBoats> remembered,
            SessionTelemetry telemetry,
            OperatorModels models,
            SessionMessages messages,
            LongSupplier nowMillis) {
        this.connector = connector;
        this.nowMillis = nowMillis;
        keepsTelemetry = setup.journal().keepsTelemetry();
        boolean keepsReasons = setup.runtime() instanceof SessionRuntime.RealTime;
        monitor = new BoatMonitor(history, telemetry, messages, models.missions()::title, keepsReasons, nowMillis);
        links = new LinkWatch(models.health());
        unreached = new UnreachedWatch(models, messages, remembered);
        poses = new PoseLog(history, telemetry);
        log = new BoatLog(connector::boats, setup.services().error(), models.missions()::title, telemetry, nowMillis);
    }

    /** Something happened to the fleet. */
    void take(FleetEvent event) {
        if (keepsTelemetry) {
            log.take(event);
        }
        if (!closed) {
            links.take(event, nowMillis.getAsLong());
        }
    }

    /** To be called once a second. */
    void look() {
        long now = nowMillis.getAsLong();
        lookAtBoats();
        links.look(now);
        unreached.look(connector.linkReports(), now);
        if (keepsTelemetry) {
            log.look();
            poses.look(now);
        }
    }

    /** Looks at what the boats do, and at nothing else. */
    void lookAtBoats() {
        monitor.look(connector.boats());
    }

    /** Writes down where the boats are now. */
    void flushPoses() {
        poses.flush(nowMillis.getAsLong());
    }

    /** The caller writes down where boats are. From any thread. */
    void leavePosesToCaller() {
        poses.stop();
    }

    /** Nothing more is reported of links or written down. From any thread. */
    void close() {
        closed = true;
        log.close();
    }
}
