package org.sami.mavlink.onboard;

import java.util.Optional;

/** What a ground station orders a vehicle to do, its values checked: places are on the earth, speeds and sticks are numbers. */
public sealed interface StationOrder {
    /** Lets the motors turn. */
    record Arm() implements StationOrder {}

    /** Motors off. */
    record Disarm() implements StationOrder {}

    /** Changes the mode to a number of the autopilot's. */
    record ChangeMode(long customMode) implements StationOrder {}

    /**
     * Goes to a place and stays there.
     *
     * @param latDeg degrees north, WGS 84
     * @param lonDeg degrees east, WGS 84
     * @param speedMps metres a second; empty for the speed of before
     * @param changesMode whether it is to change into the mode for it; otherwise the order is only for a vehicle in that mode
     */
    record GoTo(double latDeg, double lonDeg, Optional<Double> speedMps, boolean changesMode) implements StationOrder {}

    /** Carries out the mission from an item on; item 0 or none: where it was left. */
    record StartMission(int item) implements StationOrder {}

    /** Makes an item of the mission the one that is carried out now or next. */
    record GoOnAt(int item) implements StationOrder {}

    /** Keeps its place; the mission waits. */
    record Pause() implements StationOrder {}

    /** Changes the speed of the leg under way and of later ones, metres a second, more than 0. */
    record ChangeSpeed(double speedMps) implements StationOrder {}

    /**
     * Sticks by hand, each from -1 to 1.
     *
     * @param thrust ahead, negative astern
     * @param turn to starboard, negative to port
     */
    record Steer(double thrust, double turn) implements StationOrder {}
}
