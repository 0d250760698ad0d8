package org.sami.crw.sim.tcp;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.LongSupplier;
import org.sami.crw.proxy.BatteryState;
import org.sami.crw.proxy.BoatCommand;
import org.sami.crw.proxy.BoatListener;
import org.sami.crw.proxy.BoatListeners;
import org.sami.crw.proxy.BoatReading;
import org.sami.crw.proxy.BoatStatus;
import org.sami.crw.proxy.FollowPath;
import org.sami.crw.proxy.LinkState;
import org.sami.crw.proxy.Withdrawal;
import org.sami.crw.proxy.tcp.BaseListener;
import org.sami.crw.proxy.tcp.LinkAlarm;
import org.sami.crw.sim.report.ReadingResult;
import org.sami.crw.sim.run.ReadingRecorder;
import org.sami.spn.value.GeoPoint;

/** Hears everything of the boats and their links: passes it to the domain, and keeps what the run's report tells. */
final class FleetListener implements BaseListener, BoatListener {
    /** Who wants to know that a boat was at points of its path. */
    interface Arrivals {
        /** A boat says that these points are behind it; called on the base's thread. */
        void at(String boat, List<GeoPoint> points, long atMillis);
    }

    private final FleetStatus desk;
    private final SessionNotes notes;
    private final OperatorNotices notices;
    private final LongSupplier nowMillis;
    private final ReadingRecorder readings;
    private final Map<String, Integer> reported = new HashMap<>();
    private volatile Arrivals arrivals = (boat, points, atMillis) -> {};
    private volatile boolean deaf;
    private Optional<BoatListener> domain = Optional.empty();

    FleetListener(
            FleetStatus desk,
            SessionNotes notes,
            OperatorNotices notices,
            LongSupplier nowMillis,
            ReadingRecorder readings) {
        this.desk = desk;
        this.notes = notes;
        this.notices = notices;
        this.nowMillis = nowMillis;
        this.readings = readings;
    }

    /** From now on the domain hears of boats; before the first is connected. */
    void passTo(BoatListener domainListener) {
        domain = Optional.of(domainListener);
    }

    /** From now on somebody hears of arrivals. From any thread. */
    void tellArrivals(Arrivals ear) {
        arrivals = ear;
    }

    /** From now on it hears nothing: the run is over, and what becomes of links now is its own doing. From any thread. */
    void close() {
        deaf = true;
    }

    @Override
    public BoatListener found(String boatId) {
        return new BoatListeners(this, domain.orElseThrow());
    }

    @Override
    public void onAlarm(LinkAlarm alarm) {
        notices.ofLink(nowMillis.getAsLong(), "ALARM: " + alarm.text());
    }

    @Override
    public void onFailure(String what, RuntimeException cause) {
        notices.ofLink(nowMillis.getAsLong(), "fault in " + what + ": " + cause);
    }

    @Override
    public void onStatus(BoatStatus status) {
        if (deaf) {
            return;
        }
        status.pose()
                .ifPresent(pose -> desk.told(
                        status.boatId(),
                        new FleetStatus.Told(
                                pose.position(),
                                pose.headingRad(),
                                pose.speedMps(),
                                status.battery().map(BatteryState::percent).orElse(100.0),
                                pose.boatTimeMs())));
    }

    @Override
    public void onReading(String boatId, BoatReading reading) {
        if (!deaf) {
            ReadingResult result = readings.result(boatId, reading);
            readings.add(result);
            notes.reading(result);
        }
    }

    @Override
    public void onLinkChange(BoatStatus status) {
        if (deaf) {
            return;
        }
        if (status.link() == LinkState.LINKED) {
            desk.linked(status.boatId(), status.bootId());
            notes.linked(status.boatId(), status.bootId());
        } else if (status.link() == LinkState.LOST) {
            desk.lost(status.boatId());
            notes.lost(status.boatId());
        }
    }

    /**
     * The visits are written down before the domain makes an input of the progress: whoever takes the run up either knows both or
     * has the boat go there again.
     */
    @Override
    public void onProgress(String boatId, BoatCommand command, int visitedCount) {
        if (command instanceof FollowPath path) {
            int before = Math.max(path.startIndex(), reported.getOrDefault(command.commandId(), 0));
            if (visitedCount > before) {
                reported.put(command.commandId(), visitedCount);
                List<GeoPoint> points = path.points().subList(before, visitedCount);
                long at = nowMillis.getAsLong();
                points.forEach(point -> notes.visited(at, boatId, point));
                arrivals.at(boatId, points, at);
            }
        }
    }

    @Override
    public void onCompleted(String boatId, BoatCommand command) {
        reported.remove(command.commandId());
    }

    @Override
    public void onFailed(String boatId, BoatCommand command, String reason) {
        reported.remove(command.commandId());
    }

    @Override
    public void onWithdrawn(String boatId, BoatCommand command, Withdrawal why) {
        reported.remove(command.commandId());
    }
}
