package org.sami.crw.sim.fleet;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.sami.crw.proxy.BoatProxy;
import org.sami.crw.proxy.command.FollowPath;
import org.sami.crw.sim.clock.VirtualClock;
import org.sami.crw.sim.hull.SimulatedHull;
import org.sami.spn.protocol.Priority;
import org.sami.spn.value.GeoPoint;

/** A small simulated world for tests: real servers, hulls, pipes and proxies. */
final class SimulatedTestWorld {
    final VirtualClock clock = new VirtualClock();
    final Map<String, ProxyEventRecorder> recorders = new LinkedHashMap<>();
    final SimulatedFleet fleet;

    SimulatedTestWorld(int boats) {
        this(boats, 1, FleetConfig.DEFAULT);
    }

    SimulatedTestWorld(int boats, long seed, FleetConfig config) {
        fleet = new SimulatedFleet(
                clock,
                seed,
                boats,
                45.4,
                10.9,
                id -> recorders.computeIfAbsent(id, any -> new ProxyEventRecorder()),
                config);
        fleet.start();
    }

    void run(double seconds) {
        clock.runUntil(clock.nowMs() + Math.round(seconds * 1000));
    }

    SimulatedBoat boat() {
        return fleet.boats().get(0);
    }

    SimulatedHull hull() {
        return boat().hull();
    }

    BoatProxy proxy() {
        return boat().proxy();
    }

    List<String> reports() {
        return recorders.get("boat1").lines;
    }

    /** Points on the plane, given as metres east and north in turn. */
    List<GeoPoint> points(double... eastNorth) {
        List<GeoPoint> points = new ArrayList<>();
        for (int i = 0; i < eastNorth.length; i += 2) {
            points.add(GeoPoint.of(
                    fleet.frame().latDeg(eastNorth[i], eastNorth[i + 1]),
                    fleet.frame().lonDeg(eastNorth[i], eastNorth[i + 1])));
        }
        return points;
    }

    FollowPath path(long mission, double... eastNorth) {
        return path("m" + mission + "-boat1", mission, Priority.MEDIUM, eastNorth);
    }

    FollowPath path(String id, long mission, Priority priority, double... eastNorth) {
        return FollowPath.of(id, mission, mission * 10, points(eastNorth), priority);
    }

    double distanceTo(double eastM, double northM) {
        return Math.hypot(hull().eastM() - eastM, hull().northM() - northM);
    }
}
