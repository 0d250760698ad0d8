package org.sami.boat.server;

import java.util.ArrayList;
import java.util.List;
import org.sami.boat.link.Waypoint;
import org.sami.boat.server.vehicle.LocalFrame;
import org.sami.boat.server.vehicle.Vehicle;

/** Drives the boat to its home position, on the shortest of the ways that it knows, or straight. */
final class HomewardDrive {
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

    /** Begins the way where the boat is. */
    void begin() {
        List<Waypoint> points = new ArrayList<>(waysHome.turns(vehicle.latDeg(), vehicle.lonDeg()));
        points.add(home.origin(config.returnSpeedMps()));
        way = new WaypointTrack("", points);
        follower.follow(way);
        waysHome.goOn(points.subList(0, points.size() - 1));
    }

    boolean isHome() {
        return way.turnsAhead().isEmpty()
                && home.distanceM(vehicle.latDeg(), vehicle.lonDeg()) <= config.arrivalRadiusM();
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
