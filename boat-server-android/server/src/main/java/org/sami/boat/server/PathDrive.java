package org.sami.boat.server;

import org.sami.boat.link.SetWaysHome;
import org.sami.boat.server.vehicle.LocalFrame;

/** Drives the boat along its waypoint list, and keeps the ways home of the leg that it drives. */
final class PathDrive {
    private final PathFollower follower;
    private final WaysHome waysHome;
    private WaypointTrack track = WaypointTrack.NONE;
    private double velocityMultiplier = 1;

    PathDrive(PathFollower follower, WaysHome waysHome) {
        this.follower = follower;
        this.waysHome = waysHome;
    }

    WaypointTrack track() {
        return track;
    }

    void replace(WaypointTrack newTrack) {
        track = newTrack;
    }

    double velocityMultiplier() {
        return velocityMultiplier;
    }

    /** Scales the speed of every leg. */
    void setVelocityMultiplier(double multiplier) {
        velocityMultiplier = multiplier;
    }

    /** Takes the ways home from the list that the boat holds. */
    void setWaysHome(SetWaysHome ways) {
        waysHome.set(ways, track.nextIndex());
    }

    /** The list starts at a waypoint; its size, which is the end of the list, counts as one. */
    void startAt(int index) {
        track.startAt(index);
        waysHome.start(track.listId(), index);
    }

    /** Begins the first leg where the boat is. */
    void begin() {
        follower.follow(track);
    }

    /**
     * Drives for one tick, until the list is completed.
     *
     * @return whether a waypoint was reached
     */
    boolean tick(long nowMs, double seconds) {
        boolean reached = follower.isAtTarget();
        if (reached) {
            track.reached();
            if (track.isCompleted()) {
                return true;
            }
            follower.goOn(track);
            waysHome.driveLeg(track.nextIndex());
        }
        follower.steer(velocityMultiplier, nowMs, seconds);
        return reached;
    }

    /** The end of the leg. */
    LocalFrame end() {
        return follower.end();
    }
}
