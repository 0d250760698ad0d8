package org.sami.crw.proxy;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import org.sami.boat.link.Ack;
import org.sami.boat.link.BoatMode;
import org.sami.boat.link.CommandMessage;
import org.sami.boat.link.Heartbeat;
import org.sami.boat.link.HeldWaypoints;
import org.sami.boat.link.LinkCodec;
import org.sami.boat.link.LinkException;
import org.sami.boat.link.LinkMessage;
import org.sami.boat.link.Progress;
import org.sami.boat.link.ReadBack;
import org.sami.boat.link.Role;
import org.sami.boat.link.StartWaypoints;
import org.sami.boat.link.Telemetry;
import org.sami.boat.link.UploadWaypoints;
import org.sami.boat.link.Welcome;
import org.sami.crw.fleet.FleetEvent;
import org.sami.crw.proxy.link.ProxyConfig;
import org.sami.spn.value.GeoPoint;

/** A proxy and the boat that it talks to, whose every word the test says. */
final class ScriptedBoat {
    final List<LinkMessage> said = new ArrayList<>();
    final BoatProxy proxy;
    private final LinkCodec codec = new LinkCodec();
    private long nowMs = 1000;
    private long sequence;

    ScriptedBoat(Consumer<FleetEvent> listener) {
        proxy = new BoatProxy("boat1", this::keep, listener, ProxyConfig.DEFAULT);
    }

    private void keep(byte[] frame) {
        try {
            said.add(codec.decode(frame).message());
        } catch (LinkException e) {
            throw new AssertionError(e);
        }
    }

    void says(LinkMessage message) {
        proxy.receive(codec.encode(sequence++, message), nowMs);
    }

    /** Lets time pass in silence. */
    void silent(double seconds) {
        for (int i = 0; i < Math.round(seconds * 10); i++) {
            nowMs += 100;
            proxy.tick(nowMs);
        }
    }

    /** Lets time pass while the boat says once a second where it is, on its path. */
    void onPathAt(GeoPoint position, double batteryPercent, double seconds) {
        for (int i = 0; i < seconds; i++) {
            silent(1);
            says(new Telemetry(position.latDeg(), position.lonDeg(), 0, 0, batteryPercent, BoatMode.PATH, nowMs));
        }
    }

    void alive(double seconds) {
        for (int i = 0; i < seconds; i++) {
            silent(1);
            says(new Heartbeat(nowMs));
        }
    }

    void linked(String bootId) {
        says(new Welcome("boat1", bootId, Role.COMMANDER, ""));
        says(new Progress("", 0, false));
    }

    <M extends LinkMessage> M last(Class<M> kind) {
        return said.stream()
                .filter(kind::isInstance)
                .map(kind::cast)
                .reduce((a, b) -> b)
                .orElseThrow();
    }

    void acknowledges(Class<? extends CommandMessage> kind) {
        says(new Ack(last(kind).commandId()));
    }

    void holdsWhatWasSent() {
        UploadWaypoints upload = last(UploadWaypoints.class);
        says(new HeldWaypoints(last(ReadBack.class).commandId(), upload.listId(), upload.waypoints()));
    }

    /** The boat takes the path that is being uploaded and follows it. */
    void setsOut() {
        acknowledges(UploadWaypoints.class);
        holdsWhatWasSent();
        acknowledges(StartWaypoints.class);
    }
}
