package org.sami.boat.link;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;

/**
 * Keep station here, turn once all round and take pictures at equal angles; {@link PanoramaReport} reports the end. The waypoint list and its progress
 * stay.
 */
public final class TakePanorama extends CommandMessage {
    /** Most pictures of one turn. */
    public static final int MAX_PICTURES = 360;

    static final String TYPE = "panorama";

    private final int pictures;

    /** Makes a message of checked values; a value out of its range is an {@link IllegalArgumentException}. */
    public TakePanorama(String commandId, int pictures) {
        super(commandId);
        this.pictures = (int) Checks.range("pictures", pictures, 1, MAX_PICTURES);
    }

    static TakePanorama read(Fields in) throws LinkException {
        return new TakePanorama(in.text("command"), in.index("pictures"));
    }

    /** Number of pictures. */
    public int pictures() {
        return pictures;
    }

    @Override
    public String type() {
        return TYPE;
    }

    @Override
    void writeCommand(JsonGenerator out) throws IOException {
        out.writeNumberField("pictures", pictures);
    }
}
