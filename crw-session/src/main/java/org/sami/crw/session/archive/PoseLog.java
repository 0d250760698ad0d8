package org.sami.crw.session.archive;

import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import org.sami.session.record.FleetHistory;
import org.sami.session.record.SessionTelemetry;

/**
 * Records boats' positions for tracks and for a later process: one pose each time a boat has moved by the spacing, and one a minute while it reports
 * changes. The spacing doubles with each {@value #POSES_A_SPACING} poses of a boat, so that a session of weeks stays readable. For the fleet's
 * thread.
 */
public final class PoseLog {
    /** Half of what a boat covers between two looks at its full speed. */
    private static final double FIRST_SPACING_M = 1;

    private static final int POSES_A_SPACING = 10_000;
    private static final long LONGEST_MS = 60_000;

    private final FleetHistory history;
    private final SessionTelemetry telemetry;
    private final Map<String, Written> boats = new HashMap<>();
    private volatile boolean stopped;

    private static final class Written {
        private Optional<FleetHistory.Report> last = Optional.empty();
        private long atMillis;
        private double distanceM;
        private int poses;

        double spacingM() {
            return FIRST_SPACING_M * (1L << Math.min(40, poses / POSES_A_SPACING));
        }
    }

    /** A log of the positions that a history knows, into that telemetry. */
    public PoseLog(FleetHistory history, SessionTelemetry telemetry) {
        this.history = history;
        this.telemetry = telemetry;
    }

    /** Stops recording: another log records from now on. From any thread. */
    public void stop() {
        stopped = true;
    }

    /** Writes the poses that are due; to be called once a second. */
    public void look(long nowMillis) {
        each(nowMillis, false);
    }

    /** Writes the latest poses, due or not. */
    public void flush(long nowMillis) {
        each(nowMillis, true);
    }

    private void each(long nowMillis, boolean all) {
        if (!stopped) {
            history.boats().forEach(boat -> look(boat, nowMillis, all));
        }
    }

    private void look(FleetHistory.Boat boat, long nowMillis, boolean all) {
        Written written = boats.computeIfAbsent(boat.id(), id -> new Written());
        if (written.last.equals(Optional.of(boat.report()))) {
            return;
        }
        boolean due = all
                || written.last.isEmpty()
                || boat.distanceM() - written.distanceM >= written.spacingM()
                || nowMillis - written.atMillis >= LONGEST_MS;
        if (due) {
            written.last = Optional.of(boat.report());
            written.atMillis = nowMillis;
            written.distanceM = boat.distanceM();
            written.poses++;
            telemetry.pose(nowMillis, boat.id(), boat.report(), boat.distanceM());
        }
    }
}
