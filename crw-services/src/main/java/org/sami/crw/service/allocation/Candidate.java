package org.sami.crw.service.allocation;

import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.TreeSet;
import org.sami.spn.value.GeoPoint;

/**
 * A boat to which work can be allocated.
 *
 * @param at its position
 * @param offers its capabilities, in alphabetical order
 * @param begun work that it has begun and keeps, in its order; new work comes after it
 * @param rangeM distance for which its charge certainly lasts, in metres; empty where unknown
 * @param home where it returns to, if its charge has to last for the way there too
 * @param speedMps its speed on its paths, in m/s; empty where unknown, as of the fastest boat then
 * @param turningRadiusM radius of its narrowest turn, in metres; 0 for one that turns on the spot, or of which it is not known
 */
public record Candidate(
        String boat,
        GeoPoint at,
        Set<String> offers,
        List<WorkItem> begun,
        OptionalDouble rangeM,
        Optional<GeoPoint> home,
        OptionalDouble speedMps,
        double turningRadiusM) {
    public Candidate {
        Objects.requireNonNull(boat, "boat");
        Objects.requireNonNull(at, "at");
        offers = java.util.Collections.unmodifiableSet(new TreeSet<>(offers));
        begun = List.copyOf(begun);
        Objects.requireNonNull(rangeM, "rangeM");
        Objects.requireNonNull(home, "home");
        if (!(speedMps.orElse(1) > 0)) {
            throw new IllegalArgumentException(boat + " drives at more than 0 m/s, not at " + speedMps);
        }
        if (!(turningRadiusM >= 0 && turningRadiusM < Double.POSITIVE_INFINITY)) {
            throw new IllegalArgumentException(boat + " turns in a circle of 0 m or more, not of " + turningRadiusM);
        }
    }

    /** A boat that turns on the spot. */
    public Candidate(
            String boat,
            GeoPoint at,
            Set<String> offers,
            List<WorkItem> begun,
            OptionalDouble rangeM,
            Optional<GeoPoint> home,
            OptionalDouble speedMps) {
        this(boat, at, offers, begun, rangeM, home, speedMps, 0);
    }

    /** A boat of whose charge and speed nothing is known. */
    public Candidate(String boat, GeoPoint at, Set<String> offers, List<WorkItem> begun) {
        this(boat, at, offers, begun, OptionalDouble.empty(), Optional.empty(), OptionalDouble.empty());
    }

    /** The same boat with a charge that is sure to take it so far, in metres. */
    public Candidate within(double metres) {
        return new Candidate(boat, at, offers, begun, OptionalDouble.of(metres), home, speedMps, turningRadiusM);
    }

    /** The same boat, which is to come home as well. */
    public Candidate returning(GeoPoint to) {
        return new Candidate(boat, at, offers, begun, rangeM, Optional.of(to), speedMps, turningRadiusM);
    }

    /** The same boat at a speed, in m/s. */
    public Candidate atSpeed(double mps) {
        return new Candidate(boat, at, offers, begun, rangeM, home, OptionalDouble.of(mps), turningRadiusM);
    }

    /** The same boat with a turning circle of a radius, in metres. */
    public Candidate turningIn(double radiusM) {
        return new Candidate(boat, at, offers, begun, rangeM, home, speedMps, radiusM);
    }

    /** A boat that has begun nothing and offers nothing in particular. */
    public static Candidate at(String boat, GeoPoint at) {
        return new Candidate(boat, at, Set.of(), List.of());
    }

    /** Whether it can do this work. */
    public boolean canDo(WorkItem work) {
        return offers.containsAll(work.needs());
    }

    /** Where it is free for more: at the last work that it has begun, else where it is. */
    public GeoPoint freeAt() {
        return begun.isEmpty() ? at : begun.get(begun.size() - 1).location();
    }
}
