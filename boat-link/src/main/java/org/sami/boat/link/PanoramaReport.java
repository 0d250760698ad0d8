package org.sami.boat.link;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;

/** The pictures of a {@link TakePanorama} are taken and kept on board. Sent once, to every client. */
public final class PanoramaReport extends LinkMessage {
    static final String TYPE = "pictures";

    private final String commandId;
    private final int pictures;
    private final double latDeg;
    private final double lonDeg;

    /**
     * Makes a message of checked values; a value out of its range is an {@link IllegalArgumentException}.
     *
     * @param commandId of the command that asked for them
     * @param latDeg position of the boat at the last picture, by its own estimate
     */
    public PanoramaReport(String commandId, int pictures, double latDeg, double lonDeg) {
        this.commandId = Checks.id("command", commandId);
        this.pictures = (int) Checks.range("pictures", pictures, 1, TakePanorama.MAX_PICTURES);
        this.latDeg = Checks.latitude(latDeg);
        this.lonDeg = Checks.longitude(lonDeg);
    }

    static PanoramaReport read(Fields in) throws LinkException {
        return new PanoramaReport(in.text("command"), in.index("pictures"), in.number("lat"), in.number("lon"));
    }

    /** The command that asked for the pictures. */
    public String commandId() {
        return commandId;
    }

    /** How many were taken. */
    public int pictures() {
        return pictures;
    }

    /** WGS 84 latitude in degrees. */
    public double latDeg() {
        return latDeg;
    }

    /** WGS 84 longitude in degrees. */
    public double lonDeg() {
        return lonDeg;
    }

    @Override
    public String type() {
        return TYPE;
    }

    @Override
    void write(JsonGenerator out) throws IOException {
        out.writeStringField("command", commandId);
        out.writeNumberField("pictures", pictures);
        out.writeNumberField("lat", latDeg);
        out.writeNumberField("lon", lonDeg);
    }
}
