package org.sami.session.record;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import org.sami.crw.proxy.command.BoatCommand;
import org.sami.crw.proxy.command.FollowPath;
import org.sami.crw.proxy.command.KeepStation;
import org.sami.crw.proxy.command.Panorama;
import org.sami.crw.proxy.command.Stop;
import org.sami.spn.protocol.Priority;
import org.sami.spn.value.GeoPoint;

/** Commands for boats as a session's journal notes them. */
public final class CommandJson {
    private static final ObjectMapper JSON = new ObjectMapper();
    private static final String PATH = "path";
    private static final String STATION = "station";
    private static final String PANORAMA = "panorama";
    private static final String STOP = "stop";

    private CommandJson() {}

    /** Writes a command, so that {@link #read} gives the same again. */
    public static ObjectNode write(BoatCommand command) {
        ObjectNode json = JSON.createObjectNode()
                .put("id", command.commandId())
                .put("mission", command.mission())
                .put("activation", command.activation())
                .put("priority", command.priority().name())
                .put("block", command.block());
        if (command instanceof FollowPath path) {
            json.put("kind", PATH).put("start", path.startIndex());
            path.speedMps().ifPresent(speed -> json.put("speedMps", speed));
            write(path.points(), json.putArray("points"));
        } else if (command instanceof KeepStation station) {
            json.put("kind", STATION)
                    .put("latDeg", station.point().latDeg())
                    .put("lonDeg", station.point().lonDeg())
                    .put("radiusM", station.radiusM());
        } else if (command instanceof Panorama panorama) {
            json.put("kind", PANORAMA).put("pictures", panorama.pictures());
        } else if (command instanceof Stop) {
            json.put("kind", STOP);
        }
        return json;
    }

    /**
     * The command that was written.
     *
     * @throws IllegalArgumentException if it is none
     */
    public static BoatCommand read(JsonNode json) {
        String id = json.required("id").asText();
        long mission = json.required("mission").asLong();
        long activation = json.required("activation").asLong();
        Priority priority = Priority.valueOf(json.required("priority").asText());
        boolean block = json.required("block").asBoolean();
        String kind = json.required("kind").asText();
        return switch (kind) {
            case PATH ->
                new FollowPath(
                        id,
                        mission,
                        activation,
                        points(json.required("points")),
                        json.has("speedMps")
                                ? OptionalDouble.of(json.get("speedMps").asDouble())
                                : OptionalDouble.empty(),
                        json.required("start").asInt(),
                        priority,
                        block);
            case STATION ->
                new KeepStation(
                        id,
                        mission,
                        activation,
                        GeoPoint.of(
                                json.required("latDeg").asDouble(),
                                json.required("lonDeg").asDouble()),
                        json.required("radiusM").asDouble(),
                        priority,
                        block);
            case PANORAMA ->
                new Panorama(id, mission, activation, json.required("pictures").asInt(), priority);
            case STOP -> new Stop(id, mission, activation, priority, block);
            default -> throw new IllegalArgumentException("there is no kind of command '" + kind + "'");
        };
    }

    /** Writes points in their order, latitude and longitude of each. */
    public static void write(List<GeoPoint> points, ArrayNode json) {
        points.forEach(point -> json.add(point.latDeg()).add(point.lonDeg()));
    }

    /** Points that were written; none where nothing is. */
    public static List<GeoPoint> points(JsonNode json) {
        List<GeoPoint> points = new ArrayList<>();
        for (int i = 0; i + 1 < json.size(); i += 2) {
            points.add(GeoPoint.of(json.get(i).asDouble(), json.get(i + 1).asDouble()));
        }
        return points;
    }
}
