package org.sami.boat.server;

import java.util.ArrayList;
import java.util.List;
import org.sami.boat.link.Waypoint;
import org.sami.boat.server.vehicle.LocalFrame;
import org.sami.boat.server.vehicle.Vehicle;

/** Drives the boat to its home position, on the shortest of the ways that it knows, or straight. */
final class HomewardDrive {
    private static final double LEAST_ALTITUDE_M = 15; // of an aircraft on its way, above trees and masts

    private final ServerConfig config;
    private final Vehicle vehicle;
    private final PathFollower follower;
    private final WaysHome waysHome;
    private final LocalFrame home;
    private WaypointTrack way = WaypointTrack.NONE;

    HomewardDrive(ServerConfig config, Vehicle vehicle, PathFollower follower, WaysHome waysHome, LocalFrame home) {
        this.config = config;
        this.vehicle = vehicle;
        this.follower = follower;
        this.waysHome = waysHome;
        this.home = home;
    }

    /** Where the vehicle was when its server started. */
    LocalFrame home() {
        return home;
    }

    /** The ways on which the boat would return. */
    WaysHome waysHome() {
        return waysHome;
    }

    /** Begins the way where the boat is; an aircraft keeps its altitude until it is home, and lands there. */
    void begin() {
        double nowM = vehicle.altM().orElse(0);
        double altM = nowM > 0 ? Math.max(nowM, LEAST_ALTITUDE_M) : 0;
        List<Waypoint> points = new ArrayList<>();
        for (Waypoint turn : waysHome.turns(vehicle.latDeg(), vehicle.lonDeg())) {
            points.add(turn.at(altM));
        }
        Waypoint end = home.origin(config.returnSpeedMps());
        if (altM > 0) {
            points.add(end.at(altM));
        }
        points.add(end);
        way = new WaypointTrack("", points);
        follower.follow(way);
        waysHome.goOn(points.subList(0, points.size() - 1));
    }

    boolean isHome() {
        return way.turnsAhead().isEmpty()
                && home.distanceM(vehicle.latDeg(), vehicle.lonDeg()) <= config.arrivalRadiusM()
                && vehicle.isAtAltitude();
    }

    /** Drives for one tick. */
    void tick(long nowMs, double seconds) {
        if (follower.isAtTarget()) {
            way.reached();
            waysHome.goOn(way.turnsAhead());
            follower.goOn(way);
        }
        follower.steer(1, nowMs, seconds);
    }
}
