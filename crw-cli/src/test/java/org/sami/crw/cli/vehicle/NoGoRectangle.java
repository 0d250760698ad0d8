package org.sami.crw.cli.vehicle;

import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Objects;
import java.util.stream.IntStream;
import org.sami.boat.server.vehicle.LocalFrame;

/** A no-go area with edges to the four directions, in metres east and north of the origin of a frame. Places are latitude and longitude in degrees. */
record NoGoRectangle(LocalFrame frame, double westM, double southM, double eastM, double northM) {
    private static final ObjectMapper JSON = new ObjectMapper();
    private static final int STEPS = 1000; // of a way

    /** A list with this area alone, as the value of {@code @noGo}. */
    String typed() {
        ArrayNode areas = JSON.createArrayNode();
        ObjectNode area = areas.addObject();
        for (double[] corner : List.of(
                new double[] {westM, southM}, new double[] {eastM, southM}, new double[] {eastM, northM}, new double[] {
                    westM, northM
                })) {
            area.withArrayProperty("outline")
                    .addObject()
                    .put("lat", frame.latDeg(corner[0], corner[1]))
                    .put("lon", frame.lonDeg(corner[0], corner[1]));
        }
        return areas.toString();
    }

    /** How many of these places are within. */
    long inside(List<double[]> places) {
        return places.stream()
                .filter(at -> isInside(frame.eastM(at[0], at[1]), frame.northM(at[0], at[1])))
                .count();
    }

    private boolean isInside(double atEastM, double atNorthM) {
        return westM < atEastM && atEastM < eastM && southM < atNorthM && atNorthM < northM;
    }

    /** Whether the straight way from one place to another leads through. */
    boolean isCutBy(double[] from, double[] to) {
        return inside(IntStream.rangeClosed(0, STEPS)
                        .mapToObj(step -> new double[] {
                            from[0] + (to[0] - from[0]) * step / STEPS, from[1] + (to[1] - from[1]) * step / STEPS
                        })
                        .toList())
                > 0;
    }

    /**
     * A plan of a domain's library in a project of its own that has a variable for no-go areas.
     *
     * @param areas the variable's value, as text
     * @param folder for the project's file
     */
    static Path project(String domain, String plan, String areas, Path folder) throws IOException {
        String resource = "/org/sami/domain/" + domain + "/plans/" + plan + ".json";
        try (InputStream library =
                Objects.requireNonNull(NoGoRectangle.class.getResourceAsStream(resource), resource)) {
            ObjectNode project = (ObjectNode) JSON.readTree(library);
            project.withArrayProperty("globals")
                    .addObject()
                    .put("name", "@noGo")
                    .put("type", "list<area>")
                    .set("initial", JSON.readTree(areas));
            return Files.writeString(folder.resolve(plan + ".json"), project.toString());
        }
    }
}
