package org.sami.boat.hull.board;

import java.util.Optional;
import org.sami.boat.hull.settings.HullSettings;

/**
 * What is commanded of the board, and whether the board is there: a state machine without threads. Motors are 0 while the board does not report, while nobody
 * has commanded for {@link #STALE_MS}, and for what is no number. A stop is commanded as 0, ten times a second, as a board that hears nothing disarms. Safe
 * for use by several threads.
 */
final class MotorArbiter {
    /** The board reports ten times a second; after so long without a line it is silent. */
    static final long SILENT_MS = 1000;

    /** The boat server commands ten times a second; after so long it hangs. */
    static final long STALE_MS = 1000;

    private HullSettings hull;
    private double port;
    private double starboard;
    private long commandedMs = Long.MIN_VALUE / 2;
    private double testPort;
    private double testStarboard;
    private long testUntilMs = Long.MIN_VALUE / 2;
    private boolean open;
    private long openedMs;
    private long heardMs = Long.MIN_VALUE / 2;
    private BoardState state = BoardState.GONE;

    MotorArbiter(HullSettings hull) {
        this.hull = hull;
    }

    synchronized HullSettings hull() {
        return hull;
    }

    synchronized void setHull(HullSettings settings) {
        hull = settings;
    }

    /** The boat server commands; motion ends a test of motors. */
    synchronized void command(double portEffort, double starboardEffort, long nowMs) {
        port = portEffort;
        starboard = starboardEffort;
        commandedMs = nowMs;
        if (portEffort != 0 || starboardEffort != 0) {
            testUntilMs = nowMs;
        }
    }

    /** Drives for a test of motors until a time, if the boat server commands nothing else; whether it does. */
    synchronized boolean test(double portEffort, double starboardEffort, long nowMs, long untilMs) {
        boolean free = (port == 0 && starboard == 0) || nowMs - commandedMs > STALE_MS;
        if (free) {
            testPort = portEffort;
            testStarboard = starboardEffort;
            testUntilMs = untilMs;
        }
        return free;
    }

    synchronized void opened(long nowMs) {
        open = true;
        openedMs = nowMs;
    }

    synchronized void lost() {
        open = false;
    }

    synchronized void heard(long nowMs) {
        heardMs = nowMs;
    }

    /** Ms since the board has said something. */
    synchronized long silentMs(long nowMs) {
        return nowMs - heardMs;
    }

    synchronized BoardState state() {
        return state;
    }

    /** The state now, if it is another than before. */
    synchronized Optional<BoardState> change(long nowMs) {
        BoardState now = now(nowMs);
        if (now == state) {
            return Optional.empty();
        }
        state = now;
        return Optional.of(now);
    }

    /** A port that was opened just now may be one that is dropped at once: only what the board says, or its silence for a while, changes the state. */
    private BoardState now(long nowMs) {
        if (!open) {
            return BoardState.GONE;
        }
        if (heardMs >= openedMs && nowMs - heardMs <= SILENT_MS) {
            return BoardState.CONNECTED;
        }
        return nowMs - Math.max(openedMs, heardMs) > SILENT_MS ? BoardState.SILENT : state;
    }

    /** Efforts of port and starboard motor that are in force. */
    synchronized double[] efforts(long nowMs) {
        if (state != BoardState.CONNECTED) {
            return new double[] {0, 0};
        }
        if (nowMs < testUntilMs) {
            return new double[] {testPort, testStarboard};
        }
        boolean fresh = nowMs - commandedMs <= STALE_MS;
        return fresh ? new double[] {port, starboard} : new double[] {0, 0};
    }

    /** What the board is commanded now. */
    synchronized MotorEfforts motors(long nowMs) {
        double[] efforts = efforts(nowMs);
        boolean tested = nowMs < testUntilMs; // a rudder alone, without the thrust and the trim of a boat that steers
        HullSettings applied = tested ? hull.change().steeringThrust(0).trim(0).build() : hull;
        return MotorMixer.mix(applied, efforts[0], efforts[1]);
    }
}
