package org.sami.crw.session;

import java.net.InetSocketAddress;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import java.util.function.LongSupplier;
import org.sami.crw.fleet.FleetEvent;
import org.sami.crw.fleet.publishing.FleetEvents;
import org.sami.crw.proxy.BoatProxy;
import org.sami.crw.proxy.command.FollowPath;
import org.sami.crw.proxy.link.LinkAlarm;
import org.sami.crw.proxy.status.BatteryState;
import org.sami.crw.proxy.status.BoatReading;
import org.sami.crw.proxy.status.BoatStatus;
import org.sami.crw.proxy.status.LinkState;
import org.sami.crw.proxy.tcp.BaseListener;
import org.sami.crw.proxy.tcp.BoatAddress;
import org.sami.crw.session.fault.ThreadGuard;
import org.sami.session.record.FleetHistory;
import org.sami.session.record.SensorValue;
import org.sami.session.record.SessionTelemetry;
import org.sami.spn.host.ListenerList;
import org.sami.spn.value.GeoPoint;

/**
 * Receives news of the boats and their links before plans do, and notes what a session keeps of them: status, telemetry, addresses. For the
 * fleet's thread, but where said.
 */
final class FleetListener implements BaseListener {
    private final FleetEvents events;
    private final FleetHistory history;
    private final SessionTelemetry telemetry;
    private final SessionMessages messages;
    private final Optional<RememberedBoats> remembered;
    private final LongSupplier nowMillis;
    private final ThreadGuard guard;
    private final ListenerList<Consumer<BoatProxy>> finders = new ListenerList<>();
    private final Map<String, Integer> reported = new HashMap<>(); // points that were passed, by command
    private final Set<String> flooding = new HashSet<>();
    private final VesselNews vesselNews = new VesselNews();
    private volatile boolean closed;

    FleetListener(
            FleetEvents events,
            FleetHistory history,
            SessionTelemetry telemetry,
            SessionMessages messages,
            Optional<RememberedBoats> remembered,
            LongSupplier nowMillis,
            ThreadGuard guard) {
        this.events = events;
        this.history = history;
        this.telemetry = telemetry;
        this.messages = messages;
        this.remembered = remembered;
        this.nowMillis = nowMillis;
        this.guard = guard;
        events.subscribe(this::take);
    }

    /** Somebody is given each boat that becomes known. From any thread. */
    void onEachBoat(Consumer<BoatProxy> finder) {
        finders.add(finder);
    }

    /** Stops noting boats and passing messages on: links that end now are ended by the session itself. From any thread. */
    void close() {
        closed = true;
        messages.close();
    }

    // ---- links, passed on to all who subscribed

    @Override
    public Consumer<FleetEvent> found(String boatId) {
        return events.found(boatId);
    }

    @Override
    public void onBoat(BoatProxy proxy) {
        finders.each(finder -> finder.accept(proxy));
        events.onBoat(proxy);
    }

    @Override
    public void onReached(String boatId, InetSocketAddress at) {
        BoatAddress address = BoatAddress.of(at);
        remembered.ifPresent(memory -> memory.reachedAt(boatId, address));
        if (history.isAt(boatId, address.toString())) {
            telemetry.address(boatId, address.toString());
        }
    }

    @Override
    public void onMoved(String boatId, InetSocketAddress from, InetSocketAddress to) {
        events.onMoved(boatId, from, to);
    }

    @Override
    public void onRemoved(String boatId) {
        remembered.ifPresent(memory -> memory.gone(boatId));
        events.onRemoved(boatId);
    }

    @Override
    public void onAlarm(LinkAlarm alarm) {
        if (alarm.kind() != LinkAlarm.Kind.SAID_BY_BOAT) { // which becomes a message to the operator
            messages.ofLink(nowMillis.getAsLong(), "ALARM: " + alarm.text());
        }
        events.onAlarm(alarm);
    }

    @Override
    public void onFailure(String what, RuntimeException cause) {
        messages.ofLink(nowMillis.getAsLong(), "fault in " + what + ": " + cause);
        events.onFailure(what, cause);
        guard.caught("fleet", cause);
    }

    // ---- boats

    private void take(FleetEvent event) {
        if (closed) {
            return;
        }
        if (event instanceof FleetEvent.StatusReported reported) {
            told(reported.status());
        } else if (event instanceof FleetEvent.LinkChanged changed) {
            linkChanged(changed.status());
        } else if (event instanceof FleetEvent.Measured measured) {
            measured(measured.boat(), measured.reading());
        } else if (event instanceof FleetEvent.TooMuchSent sent) {
            tooMuchSent(sent);
        } else if (event instanceof FleetEvent.Progressed progressed
                && progressed.command() instanceof FollowPath path) {
            progressed(progressed.boat(), path, progressed.visited());
        } else if (event instanceof FleetEvent.CommandCompleted done) {
            reported.remove(done.command().commandId());
        } else if (event instanceof FleetEvent.CommandFailed failed) {
            reported.remove(failed.command().commandId());
        } else if (event instanceof FleetEvent.CommandWithdrawn withdrawn) {
            reported.remove(withdrawn.command().commandId());
        }
    }

    private void told(BoatStatus boat) {
        boat.pose()
                .ifPresent(pose -> history.reported(
                        boat.boatId(),
                        new FleetHistory.Report(
                                pose.position(),
                                pose.headingRad(),
                                pose.speedMps(),
                                boat.battery().map(BatteryState::percent).orElse(100.0),
                                pose.boatTimeMs())));
    }

    private void linkChanged(BoatStatus boat) {
        if (boat.link() == LinkState.LINKED) {
            history.linked(boat.boatId(), boat.bootId());
            telemetry.linked(boat.boatId(), boat.bootId());
        } else if (boat.link() == LinkState.LOST) {
            history.lost(boat.boatId());
            telemetry.lost(boat.boatId());
        }
    }

    /** When it begins and when it is over: the alarm counts meanwhile. */
    private void tooMuchSent(FleetEvent.TooMuchSent sent) {
        boolean begins = sent.leftOut().active() && flooding.add(sent.boat());
        boolean ends = !sent.leftOut().active() && flooding.remove(sent.boat());
        if (begins || ends) {
            messages.ofLink(
                    nowMillis.getAsLong(),
                    (begins ? "ALARM: " : "") + sent.leftOut().words(sent.boat()));
        }
    }

    private void measured(String boat, BoatReading reading) {
        SensorValue value = SensorValue.of(nowMillis.getAsLong(), boat, reading);
        telemetry.reading(value);
        messages.each(listener -> listener.onReading(value));
        vesselNews.seen(boat, reading, nowMillis.getAsLong()).ifPresent(messages::tell);
    }

    /**
     * The visits are written down before the domain makes an input of the progress: whoever resumes either knows both or has the boat
     * go there again.
     */
    private void progressed(String boat, FollowPath path, int visited) {
        int before = Math.max(path.startIndex(), reported.getOrDefault(path.commandId(), 0));
        if (visited > before) {
            reported.put(path.commandId(), visited);
            List<GeoPoint> points = path.points().subList(before, visited);
            long at = nowMillis.getAsLong();
            points.forEach(point -> telemetry.visited(at, boat, point));
            messages.each(listener -> listener.onPassed(boat, points, at));
        }
    }
}
