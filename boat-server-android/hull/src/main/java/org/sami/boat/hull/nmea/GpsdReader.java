package org.sami.boat.hull.nmea;

import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.core.StreamReadConstraints;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.util.function.Consumer;
import org.sami.boat.hull.position.GpsFix;

/** Reads positions from the reports of gpsd: its TPV objects, one a line. Other reports are left out, what cannot be read is counted. One thread. */
public final class GpsdReader {
    /** What gpsd is sent so that it reports. */
    public static final String WATCH = "?WATCH={\"enable\":true,\"json\":true}\n";

    /** The longest line that is read: reports on satellites are long. */
    public static final int MAX_BYTES = 10_240;

    /** Where gpsd listens. */
    public static final int PORT = 2947;

    private static final int MAX_DEPTH = 16;
    private static final int LEAST_MODE = 2; // a position without height

    private final ObjectMapper json;
    private final Consumer<GpsFix> fixes;
    private long unread;

    /** A reader that passes on the positions. */
    public GpsdReader(Consumer<GpsFix> fixes) {
        this.fixes = fixes;
        StreamReadConstraints limits =
                StreamReadConstraints.builder().maxNestingDepth(MAX_DEPTH).build();
        json = new ObjectMapper(
                JsonFactory.builder().streamReadConstraints(limits).build());
    }

    /** Reads a line. */
    public void line(String line) {
        try {
            JsonNode report = json.readTree(line);
            if (!report.isObject()) {
                unread++;
            } else if (report.path("class").asText().equals("TPV")
                    && report.path("mode").asInt() >= LEAST_MODE) {
                fixes.accept(fix(report));
            }
        } catch (JsonProcessingException damaged) {
            unread++;
        }
    }

    private static GpsFix fix(JsonNode report) {
        double eph = number(report, "eph");
        double accuracyM = Double.isNaN(eph) ? Math.max(number(report, "epx"), number(report, "epy")) : eph;
        return new GpsFix(
                number(report, "lat"),
                number(report, "lon"),
                accuracyM / 2, // gpsd gives 95 % bounds
                number(report, "speed"),
                Math.toRadians(number(report, "track")));
    }

    private static double number(JsonNode report, String name) {
        JsonNode value = report.path(name);
        return value.isNumber() ? value.asDouble() : Double.NaN;
    }

    /** How many lines could not be read. */
    public long unread() {
        return unread;
    }
}
