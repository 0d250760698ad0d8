package org.sami.boat.server;

import java.util.Collections;
import java.util.List;
import org.sami.boat.link.Progress;
import org.sami.boat.link.Waypoint;

/** The boat's waypoint list and its progress along it. */
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

    /** The waypoints ahead, without the last one. */
    List<Waypoint> turnsAhead() {
        int end = waypoints.size() - 1;
        return waypoints.subList(Math.min(next, end), end);
    }

    /** The waypoint to head for; only while the track is not completed. */
    Waypoint target() {
        return waypoints.get(next);
    }

    /** Whether there is a waypoint {@code count} places after the target. */
    boolean hasAfterTarget(int count) {
        return next + count < waypoints.size();
    }

    /** The waypoint {@code count} places after the target. */
    Waypoint afterTarget(int count) {
        return waypoints.get(next + count);
    }

    boolean isCompleted() {
        return completed;
    }

    void reached() {
        startAt(next + 1);
    }

    /** Whether a report states exactly this progress. */
    boolean isAt(Progress report) {
        return listId.equals(report.listId()) && next == report.nextIndex() && completed == report.completed();
    }

    Progress progress() {
        return new Progress(listId, next, completed);
    }
}
