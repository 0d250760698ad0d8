package org.sami.crw.sim.picture;

import java.time.Instant;
import java.util.List;
import java.util.Objects;
import org.sami.spn.value.GeoPoint;

/**
 * What is before a camera at one moment. A camera in the air looks straight down, every other one level ahead.
 *
 * @param boat that takes the picture
 * @param at where it is, with its height above the place of its take-off in metres; 0 for a boat
 * @param headingRad of boat and camera, clockwise from true north
 * @param time at which it is taken
 * @param seed of the water: coast and what floats follow from it, equal for all boats of one water
 * @param home where the boat was launched, with a jetty
 * @param others the other boats that are known there
 */
public record Scene(
        String boat, GeoPoint at, double headingRad, Instant time, long seed, GeoPoint home, List<SeenBoat> others) {

    private static final double AIR_M = 2;

    /**
     * Another boat, or a robot that flies.
     *
     * @param name of the boat
     * @param at where it is, with its height above the place of its take-off in metres; 0 for a boat
     * @param headingRad clockwise from true north
     * @param flies whether it is a copter, on the ground or in the air
     */
    public record SeenBoat(String name, GeoPoint at, double headingRad, boolean flies) {
        /** One that does not fly. */
        public SeenBoat(String name, GeoPoint at, double headingRad) {
            this(name, at, headingRad, false);
        }

        /** Checks that nothing is missing. */
        public SeenBoat {
            Objects.requireNonNull(name, "name");
            Objects.requireNonNull(at, "at");
        }
    }

    /** Copies the list. */
    public Scene {
        Objects.requireNonNull(boat, "boat");
        Objects.requireNonNull(at, "at");
        Objects.requireNonNull(time, "time");
        Objects.requireNonNull(home, "home");
        others = List.copyOf(others);
    }

    /** Whether the camera is in the air, and so looks straight down. */
    public boolean isFromAbove() {
        return at.altM() >= AIR_M;
    }

    /** The same with these other boats. */
    public Scene with(List<SeenBoat> boats) {
        return new Scene(boat, at, headingRad, time, seed, home, boats);
    }
}
