package org.sami.boat.server;

import java.util.Collections;
import java.util.List;
import org.sami.boat.link.Progress;
import org.sami.boat.link.Waypoint;

/** The waypoint list that the boat holds, and how far it is along it. */
final class WaypointTrack {
    static final WaypointTrack NONE = new WaypointTrack("", Collections.emptyList());

    private final String listId;
    private final List<Waypoint> waypoints;
    private int next;
    private boolean completed;

    WaypointTrack(String listId, List<Waypoint> waypoints) {
        this.listId = listId;
        this.waypoints = waypoints;
    }

    String listId() {
        return listId;
    }

    List<Waypoint> waypoints() {
        return waypoints;
    }

    int size() {
        return waypoints.size();
    }

    void startAt(int index) {
        next = index;
        completed = index == waypoints.size();
    }

    /** Index of the waypoint to head for; the size once the track is completed. */
    int nextIndex() {
        return next;
    }

    /** The waypoints ahead but for the last one. */
    List<Waypoint> turnsAhead() {
        int end = waypoints.size() - 1;
        return waypoints.subList(Math.min(next, end), end);
    }

    /** The waypoint to head for; only while the track is not completed. */
    Waypoint target() {
        return waypoints.get(next);
    }

    /** Whether so many waypoints after that there is another. */
    boolean hasAfterTarget(int count) {
        return next + count < waypoints.size();
    }

    /** The waypoint so many after the one to head for. */
    Waypoint afterTarget(int count) {
        return waypoints.get(next + count);
    }

    boolean isCompleted() {
        return completed;
    }

    void reached() {
        startAt(next + 1);
    }

    /** Whether this is what a report said. */
    boolean isAt(Progress report) {
        return listId.equals(report.listId()) && next == report.nextIndex() && completed == report.completed();
    }

    Progress progress() {
        return new Progress(listId, next, completed);
    }
}
