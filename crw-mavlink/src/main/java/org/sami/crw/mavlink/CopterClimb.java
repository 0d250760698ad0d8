package org.sami.crw.mavlink;

import java.util.Locale;
import java.util.Optional;
import org.sami.mavlink.vehicle.VehiclePosition;
import org.sami.mavlink.vehicle.VehicleSnapshot;

/** The climb of a copter to a height over its home: whether it is up, and whether it still rises. For the gateway's thread. */
final class CopterClimb {
    private static final long STILL_MS =
            15_000; // the slowest climb that ArduPilot can be set to, 0.1 m/s, is 1.5 m in it
    private static final double RISES_M = 0.5; // what the noise of heights does not feign again and again
    private static final double MOST_BELOW_M = 1;
    private static final double LEAST_BELOW_M = 0.3;
    private static final double PART_BELOW = 0.1;

    private final VehicleMotion.Climb ordered;
    private final long beganMs;
    private Optional<Double> heightM = Optional.empty(); // since it began
    private double highestM = Double.NEGATIVE_INFINITY;
    private long roseMs;

    /**
     * A climb that begins now.
     *
     * @param vehicle as it was heard last; a height that it has said by then is older than the climb
     */
    CopterClimb(VehicleMotion.Climb ordered, VehicleSnapshot vehicle, long nowMs) {
        this.ordered = ordered;
        beganMs = vehicle.heardMs();
        roseMs = nowMs;
    }

    /** What it was ordered for. */
    VehicleMotion.Climb ordered() {
        return ordered;
    }

    /** Whether a height in metres is so far below another one that it counts as lower. */
    static boolean isBelow(double heightM, double otherM) {
        return heightM < otherM - Math.max(LEAST_BELOW_M, Math.min(MOST_BELOW_M, otherM * PART_BELOW));
    }

    /**
     * The vehicle reports itself.
     *
     * @param isHeard whether it was heard just now; while it is silent, nothing is known of how it rises
     */
    void saw(VehicleSnapshot vehicle, boolean isHeard, long nowMs) {
        heightM = vehicle.position().filter(at -> at.heardMs() > beganMs).map(VehiclePosition::heightM);
        if (!isHeard || heightM.filter(metres -> metres >= highestM + RISES_M).isPresent()) {
            highestM = Math.max(highestM, heightM.orElse(highestM));
            roseMs = nowMs;
        }
    }

    /** Whether it has come to its height. */
    boolean isUp() {
        return heightM.filter(metres -> !isBelow(metres, ordered.toM())).isPresent();
    }

    /** Why it does not come to its height, in words; empty while it may. */
    Optional<String> fault(long nowMs) {
        if (isUp() || nowMs - roseMs < STILL_MS) {
            return Optional.empty();
        }
        return Optional.of(heightM.map(metres -> String.format(
                        Locale.ROOT,
                        "it is to climb to %.0f m, and has come no higher than %.1f m for %d s",
                        ordered.toM(),
                        metres,
                        STILL_MS / 1000))
                .orElseGet(() -> String.format(
                        Locale.ROOT,
                        "it is to climb to %.0f m, and has not said for %d s how high it is",
                        ordered.toM(),
                        STILL_MS / 1000)));
    }
}
