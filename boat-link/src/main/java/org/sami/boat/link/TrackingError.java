package org.sami.boat.link;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;

/** How far a boat may be off its path, as far as it knows: by the error of its position and by drift. */
public final class TrackingError {
    private static final double MOST_POSITION_M = 1000;

    private final double positionM;
    private final double driftMps;

    /**
     * Makes one of checked values; a value out of its range is an {@link IllegalArgumentException}.
     *
     * @param positionM standard deviation of the position along each axis, 0 to 1000 m
     * @param driftMps how fast current and wind carry a boat that does not steer against them, 0 to 50 m/s
     */
    public TrackingError(double positionM, double driftMps) {
        this.positionM = Checks.range("position", positionM, 0, MOST_POSITION_M);
        this.driftMps = Checks.speed("drift", driftMps);
    }

    static TrackingError read(Fields in) throws LinkException {
        try {
            return new TrackingError(in.number("position"), in.number("drift"));
        } catch (Checks.BadValueException e) {
            throw in.refused(e);
        }
    }

    /** Standard deviation of the position along each axis, in metres. */
    public double positionM() {
        return positionM;
    }

    /** How fast current and wind carry the boat, in m/s. */
    public double driftMps() {
        return driftMps;
    }

    void write(JsonGenerator out) throws IOException {
        out.writeNumberField("position", positionM);
        out.writeNumberField("drift", driftMps);
    }
}
