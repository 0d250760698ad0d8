package org.sami.mavlink.vehicle;

import io.dronefleet.mavlink.common.AutopilotVersion;
import io.dronefleet.mavlink.common.GlobalPositionInt;
import java.math.BigInteger;
import java.util.HexFormat;
import java.util.Optional;

/** By what a vehicle is recognized on a second link: the number of its autopilot, the time since its start, and its place. Used by one thread. */
final class VehicleIdentity {
    private static final long LATE_MS = 3_000; // the longest that a message takes on a radio
    private static final double NEAR_M = 100;
    private static final double FASTEST_MPS = 30;
    private static final double MS = 1_000;
    private static final double M_PER_UNIT = 0.0111195; // of a position's whole numbers, 1e-7 degrees
    private static final double DEGREES = 1e-7;

    private Optional<String> number = Optional.empty();
    private Optional<GlobalPositionInt> last = Optional.empty();
    private long lastMs;

    /** Takes a message. True where it can be compared with another one. */
    boolean take(Object payload, long nowMs) {
        if (payload instanceof AutopilotVersion version) {
            number = numberOf(version);
        } else if (payload instanceof GlobalPositionInt at) {
            last = Optional.of(at);
            lastMs = nowMs;
            return true;
        }
        return false;
    }

    /** The longer number where the autopilot has it; all zeros are none. */
    private static Optional<String> numberOf(AutopilotVersion version) {
        byte[] longer = version.uid2();
        if (longer != null && new BigInteger(1, longer).signum() != 0) {
            return Optional.of(HexFormat.of().formatHex(longer));
        }
        BigInteger shorter = version.uid();
        return shorter == null || shorter.signum() == 0 ? Optional.empty() : Optional.of(shorter.toString());
    }

    /** The number of the autopilot; empty where it has not said one. */
    Optional<String> number() {
        return number;
    }

    /** Whether the autopilot has said its number. */
    boolean hasNumber() {
        return number.isPresent();
    }

    /** Whether both have said their numbers, and these are equal. Copied memory cards of autopilots with Linux have equal ones, too. */
    boolean hasNumberOf(VehicleIdentity other) {
        return number.isPresent() && number.equals(other.number);
    }

    /** Whether both have said their numbers, and these differ: then they are two. */
    boolean isAnother(VehicleIdentity other) {
        return number.isPresent() && other.number.isPresent() && !number.equals(other.number);
    }

    /** Whether both have said since when they run and where they are. */
    boolean isComparable(VehicleIdentity other) {
        return last.isPresent() && other.last.isPresent();
    }

    /** Whether the times since the start, and the places, can be those of one vehicle. */
    boolean agrees(VehicleIdentity other) {
        GlobalPositionInt here = last.orElseThrow();
        GlobalPositionInt there = other.last.orElseThrow();
        long betweenMs = other.lastMs - lastMs;
        long offMs = there.timeBootMs() - here.timeBootMs() - betweenMs;
        return Math.abs(offMs) <= LATE_MS && distanceM(here, there) <= NEAR_M + FASTEST_MPS * Math.abs(betweenMs) / MS;
    }

    /** 0 where one of them has no position. */
    private static double distanceM(GlobalPositionInt one, GlobalPositionInt other) {
        if ((one.lat() == 0 && one.lon() == 0) || (other.lat() == 0 && other.lon() == 0)) {
            return 0;
        }
        double north = ((double) other.lat() - one.lat()) * M_PER_UNIT;
        double east = ((double) other.lon() - one.lon()) * M_PER_UNIT * Math.cos(Math.toRadians(one.lat() * DEGREES));
        return Math.hypot(north, east);
    }
}
