package org.sami.boat.link;

import com.fasterxml.jackson.core.JsonGenerator;
import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import org.sami.boat.link.Checks.BadValueException;
import org.sami.boat.link.LinkException.Fault;

/** A straight edge of a no-go area, which lies to starboard of the edge; one row of {@link NoGoEdges}. */
public final class NoGoEdge {
    private static final int NUMBERS = 4;

    private final double fromLatDeg;
    private final double fromLonDeg;
    private final double toLatDeg;
    private final double toLonDeg;

    /** An edge between two positions in WGS 84 degrees; a value out of its range is an {@link IllegalArgumentException}. */
    public NoGoEdge(double fromLatDeg, double fromLonDeg, double toLatDeg, double toLonDeg) {
        this.fromLatDeg = Checks.latitude(fromLatDeg);
        this.fromLonDeg = Checks.longitude(fromLonDeg);
        this.toLatDeg = Checks.latitude(toLatDeg);
        this.toLonDeg = Checks.longitude(toLonDeg);
    }

    static NoGoEdge read(JsonNode row, String where) throws LinkException {
        if (!row.isArray() || row.size() != NUMBERS) {
            throw new LinkException(Fault.WRONG_TYPE, where, "not a row of latitude and longitude of two positions");
        }
        double[] read = new double[NUMBERS];
        for (int i = 0; i < NUMBERS; i++) {
            read[i] = Fields.number(row.get(i), where + "/" + i);
        }
        try {
            return new NoGoEdge(read[0], read[1], read[2], read[3]);
        } catch (BadValueException e) {
            throw new LinkException(Fault.BAD_VALUE, where, String.valueOf(e.getMessage()));
        }
    }

    void write(JsonGenerator out) throws IOException {
        out.writeStartArray();
        out.writeNumber(fromLatDeg);
        out.writeNumber(fromLonDeg);
        out.writeNumber(toLatDeg);
        out.writeNumber(toLonDeg);
        out.writeEndArray();
    }

    /** WGS 84 latitude of one end in degrees. */
    public double fromLatDeg() {
        return fromLatDeg;
    }

    /** WGS 84 longitude of that end in degrees. */
    public double fromLonDeg() {
        return fromLonDeg;
    }

    /** WGS 84 latitude of the other end in degrees. */
    public double toLatDeg() {
        return toLatDeg;
    }

    /** WGS 84 longitude of that end in degrees. */
    public double toLonDeg() {
        return toLonDeg;
    }
}
