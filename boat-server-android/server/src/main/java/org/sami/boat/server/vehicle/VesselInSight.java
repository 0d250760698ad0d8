package org.sami.boat.server.vehicle;

import java.util.Objects;
import org.sami.boat.link.NearbyBoat;

/** A vessel that is not of the boat's base, as a lookout on board sees it: a circle around its middle. Immutable. */
public final class VesselInSight {
    private final NearbyBoat middle;
    private final double radiusM;

    /**
     * A vessel.
     *
     * @param middle where it is and how it moves; its age is 0
     * @param radiusM half its length, in metres
     */
    public VesselInSight(NearbyBoat middle, double radiusM) {
        this.middle = Objects.requireNonNull(middle, "middle");
        this.radiusM = radiusM;
    }

    /** Where it is and how it moves. */
    public NearbyBoat middle() {
        return middle;
    }

    /** Half its length, in metres. */
    public double radiusM() {
        return radiusM;
    }
}
