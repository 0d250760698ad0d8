package org.sami.mavlink.testing;

import io.dronefleet.mavlink.common.MissionItemInt;
import java.util.Optional;

/** How a small copter flies along its mission: up to the take-off's height, to places at their heights, and down to land. For one thread at a time. */
final class SmallFlight {
    private static final int LAND = 21;
    private static final int TAKE_OFF = 22;
    private static final double VERTICAL_MPS = 3;
    private static final double AT_HEIGHT_M = 0.2;
    private static final double IN_THE_AIR_M = 0.1;

    private final SmallBoatMotion motion;
    private final double times;
    private double heightM;
    private double highestM;
    private boolean landed;
    private double ceilingM = Double.MAX_VALUE;

    SmallFlight(SmallBoatMotion motion, double times, double heightM) {
        this.motion = motion;
        this.times = times;
        this.heightM = heightM;
        highestM = heightM;
    }

    SmallBoatMotion motion() {
        return motion;
    }

    double heightM() {
        return heightM;
    }

    double highestM() {
        return highestM;
    }

    boolean isInTheAir() {
        return heightM > IN_THE_AIR_M;
    }

    /** Whether it has just come down at an item that has it land. */
    boolean hasLanded() {
        return landed;
    }

    /** Whether what it would do first is a take-off. */
    boolean beginsWithTakeOff(SmallBoatMission mission) {
        return mission.place(motion).filter(item -> isCommand(item, TAKE_OFF)).isPresent();
    }

    private static boolean isCommand(MissionItemInt item, int number) {
        return item.command().value() == number;
    }

    /** It climbs no higher from now on. */
    void ceiling(double metres) {
        ceilingM = metres;
    }

    /** Moves for a time straight up, or down, to a height. */
    void stepTo(double toM, double seconds) {
        climb(toM, seconds);
    }

    /** Moves for a time to a place and a height. */
    void stepTo(int lat, int lon, double toM, double seconds) {
        motion.comesTo(lat, lon, motion.speed() * times * seconds);
        climb(toM, seconds);
    }

    /** Moves for a time. The number of the item that it has reached by it. */
    Optional<Integer> step(SmallBoatMission mission, double seconds) {
        landed = false;
        Optional<MissionItemInt> item = mission.place(motion);
        if (item.isEmpty()) {
            return Optional.empty();
        }
        boolean lands = isCommand(item.get(), LAND);
        boolean there = isCommand(item.get(), TAKE_OFF)
                || motion.comesTo(item.get().x(), item.get().y(), motion.speed() * times * seconds);
        if (there || !lands) {
            climb(lands ? 0 : item.get().z(), seconds);
        }
        boolean high = Math.abs(heightM - (lands ? 0 : item.get().z())) <= AT_HEIGHT_M;
        if (lands && there && high) {
            heightM = 0;
            landed = true;
            return Optional.empty(); // its autopilot does not say that it has reached the item
        }
        return there && high ? mission.arrived() : Optional.empty();
    }

    private void climb(double toM, double seconds) {
        double most = VERTICAL_MPS * times * seconds;
        heightM += Math.max(-most, Math.min(most, Math.min(toM, ceilingM) - heightM));
        highestM = Math.max(highestM, heightM);
    }
}
