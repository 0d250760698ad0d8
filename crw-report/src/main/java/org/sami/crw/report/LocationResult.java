package org.sami.crw.report;

import java.util.Objects;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalLong;
import org.sami.boat.link.MotionDefaults;

/**
 * A location that the operator gave, and whether boats were there: as they reported it, and truly. The two differ where positions err;
 * the truth is known of simulated boats in the run's own process alone.
 *
 * @param number from 1, in the order in which they were given
 * @param eastM metres east of the area's centre
 * @param northM metres north of the area's centre
 * @param reported the first visit that a boat reported
 * @param truth where the boats truly were; empty where nobody knows
 */
public record LocationResult(
        int number,
        double latDeg,
        double lonDeg,
        double eastM,
        double northM,
        Optional<Visit> reported,
        Optional<Truth> truth) {
    /**
     * A boat was at a location.
     *
     * @param atMillis simulated time
     */
    public record Visit(long atMillis, String boat) {
        public Visit {
            Objects.requireNonNull(boat, "boat");
        }
    }

    /**
     * The true positions of boats near a location.
     *
     * @param visit the first time at which one was within the radius that counts as a visit
     * @param nearestM how near any came; empty = not so near that anybody measured it
     */
    public record Truth(Optional<Visit> visit, OptionalDouble nearestM) {
        /** A boat that is as near as this, in metres, is there: it is what the boats themselves call arrived. */
        public static final double RADIUS_M = MotionDefaults.ARRIVAL_RADIUS_M;

        public Truth {
            Objects.requireNonNull(visit, "visit");
            Objects.requireNonNull(nearestM, "nearestM");
        }
    }

    public LocationResult {
        Objects.requireNonNull(reported, "reported");
        Objects.requireNonNull(truth, "truth");
    }

    /** A location of which only reports of boats are known. */
    public LocationResult(
            int number, double latDeg, double lonDeg, double eastM, double northM, Optional<Visit> reported) {
        this(number, latDeg, lonDeg, eastM, northM, reported, Optional.empty());
    }

    /** The same, of which it is known where boats truly were. */
    public LocationResult with(Truth known) {
        return new LocationResult(number, latDeg, lonDeg, eastM, northM, reported, Optional.of(known));
    }

    /** The first visit: the true one where that is known, else the reported one. */
    public Optional<Visit> visit() {
        return truth.isPresent() ? truth.get().visit() : reported;
    }

    /** When the first boat came there, in simulated time; empty = not visited. */
    public OptionalLong visitedAtMillis() {
        return visit().map(visit -> OptionalLong.of(visit.atMillis())).orElse(OptionalLong.empty());
    }

    /** That boat, else empty text. */
    public String visitedBy() {
        return visit().map(Visit::boat).orElse("");
    }

    /** Whether a boat was there: truly where that is known, else by what was reported. */
    public boolean visited() {
        return visit().isPresent();
    }
}
