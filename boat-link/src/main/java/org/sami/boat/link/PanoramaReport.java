package org.sami.boat.link;

import com.fasterxml.jackson.core.JsonGenerator;
import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.regex.Pattern;
import org.sami.boat.link.Checks.BadValueException;

/** The pictures of a {@link TakePanorama} are taken and kept on board. Sent once, to every client. */
public final class PanoramaReport extends LinkMessage {
    static final String TYPE = "pictures";

    private static final Pattern FILE_NAME = Pattern.compile("[A-Za-z0-9_][A-Za-z0-9._-]{0,119}");

    private final String commandId;
    private final int pictures;
    private final double latDeg;
    private final double lonDeg;
    private final List<String> files;

    /**
     * Makes a message of checked values; a value out of its range is an {@link IllegalArgumentException}.
     *
     * @param commandId of the command that asked for them
     * @param latDeg position of the boat at the last picture, by its own estimate
     */
    public PanoramaReport(String commandId, int pictures, double latDeg, double lonDeg) {
        this(commandId, pictures, latDeg, lonDeg, Collections.emptyList());
    }

    /**
     * Makes a message of checked values; a value out of its range is an {@link IllegalArgumentException}.
     *
     * @param commandId of the command that asked for them
     * @param latDeg position of the boat at the last picture, by its own estimate
     * @param files under which they are kept on board, in the order in which they were taken; empty if the boat names none
     */
    public PanoramaReport(String commandId, int pictures, double latDeg, double lonDeg, List<String> files) {
        this.commandId = Checks.id("command", commandId);
        this.pictures = (int) Checks.range("pictures", pictures, 1, TakePanorama.MAX_PICTURES);
        this.latDeg = Checks.latitude(latDeg);
        this.lonDeg = Checks.longitude(lonDeg);
        if (files.size() > pictures) {
            throw new BadValueException("files", files.size() + " are more than " + pictures + " pictures");
        }
        List<String> checked = new ArrayList<>();
        for (String file : files) {
            if (!FILE_NAME.matcher(file).matches()) {
                throw new BadValueException("files", "'" + file + "' names no picture");
            }
            checked.add(file);
        }
        this.files = Collections.unmodifiableList(checked);
    }

    static PanoramaReport read(Fields in) throws LinkException {
        List<String> files = new ArrayList<>();
        if (in.has("files")) {
            for (JsonNode file : in.array("files")) {
                files.add(file.asText());
            }
        }
        return new PanoramaReport(in.text("command"), in.index("pictures"), in.number("lat"), in.number("lon"), files);
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

    /** The files of the pictures on board, without a folder; empty where the boat names none. */
    public List<String> files() {
        return files;
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
        if (!files.isEmpty()) {
            out.writeArrayFieldStart("files");
            for (String file : files) {
                out.writeString(file);
            }
            out.writeEndArray();
        }
    }
}
