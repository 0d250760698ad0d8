package org.sami.mavlink.vehicle;

/**
 * Detects two vehicles with one id: the time since the autopilot's start, or the position, jumps to and fro as it cannot for a single vehicle. Used by one
 * thread.
 */
final class DuplicateIdDetector {
    private static final long WITHIN_MS = 10_000;
    private static final long REORDERED_MS =
            5_000; // a message of so long ago was not late: the autopilot counts from 0
    private static final double FASTEST_MPS = 100;
    private static final double A_JUMP_M = 200;
    private static final double M_PER_DEG = 111_195;

    private long sinceBootMs;
    private double latDeg = Double.NaN;
    private double lonDeg = Double.NaN;
    private long atMs;
    private long kindMs = Long.MIN_VALUE / 2; // when its kind changed last
    private long lastMs = Long.MIN_VALUE / 2;
    private long lastButOneMs = Long.MIN_VALUE / 2;

    /** Receives the time since the autopilot's start, in ms. True where it went back: the vehicle has started again, or another vehicle has the id. */
    boolean restarted(long bootMs, long nowMs) {
        boolean back = bootMs + REORDERED_MS < sinceBootMs;
        sinceBootMs = back ? bootMs : Math.max(sinceBootMs, bootMs);
        if (back) {
            jumped(nowMs);
        }
        return back;
    }

    /** Receives a position, in degrees. */
    void at(double lat, double lon, long nowMs) {
        double north = (lat - latDeg) * M_PER_DEG;
        double east = (lon - lonDeg) * M_PER_DEG * Math.cos(Math.toRadians(lat));
        double reach = A_JUMP_M + FASTEST_MPS * (nowMs - atMs) / 1_000;
        if (Math.hypot(north, east) > reach) { // false for the first position: its distance is NaN
            jumped(nowMs);
        }
        latDeg = lat;
        lonDeg = lon;
        atMs = nowMs;
    }

    /**
     * Another vehicle answers with the id: the time since its start and its place are its own.
     *
     * @param isOfAnotherKind where kinds change twice, there are two
     */
    void replaced(boolean isOfAnotherKind, long nowMs) {
        sinceBootMs = 0;
        latDeg = Double.NaN;
        if (isOfAnotherKind && nowMs - kindMs < WITHIN_MS) {
            jumped(nowMs);
            jumped(nowMs);
        }
        kindMs = isOfAnotherKind ? nowMs : kindMs;
    }

    private void jumped(long nowMs) {
        lastButOneMs = lastMs;
        lastMs = nowMs;
    }

    /** Whether two vehicles have the id, as far as the last seconds show. */
    boolean isDuplicate(long nowMs) {
        return nowMs - lastButOneMs < WITHIN_MS;
    }
}
