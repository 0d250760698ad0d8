package org.sami.ui.map;

import java.util.Objects;
import org.sami.palette.IdentityMark;
import org.sami.spn.value.GeoPoint;

/**
 * A vehicle as it is shown on a map.
 *
 * @param id stable, unique among vehicles
 * @param shortName the label next to it
 * @param mark its identity's
 * @param headingRad where its bow points, clockwise from true north
 * @param courseRad where it moves, clockwise from true north
 * @param speedMps how fast it moves over ground
 * @param ageS how old all this is, in seconds; older than {@link #STALE_S} it is faded and its age is written
 * @param age the same in words, as other panels have it
 * @param selected whether the operator has chosen it
 */
public record ShownVehicle(
        String id,
        String shortName,
        IdentityMark mark,
        GeoPoint at,
        double headingRad,
        double courseRad,
        double speedMps,
        double ageS,
        String age,
        boolean selected) {
    /** From this age on, in seconds, a position is out of date. */
    public static final double STALE_S = 3.5;

    /** A vehicle whose age is written in whole seconds. */
    public ShownVehicle(
            String id,
            String shortName,
            IdentityMark mark,
            GeoPoint at,
            double headingRad,
            double courseRad,
            double speedMps,
            double ageS,
            boolean selected) {
        this(id, shortName, mark, at, headingRad, courseRad, speedMps, ageS, Math.round(ageS) + " s", selected);
    }

    public ShownVehicle {
        Objects.requireNonNull(id, "id");
        Objects.requireNonNull(shortName, "shortName");
        Objects.requireNonNull(mark, "mark");
        Objects.requireNonNull(at, "at");
        Objects.requireNonNull(age, "age");
    }

    /** Whether its position is too old. */
    public boolean isStale() {
        return ageS > STALE_S;
    }
}
