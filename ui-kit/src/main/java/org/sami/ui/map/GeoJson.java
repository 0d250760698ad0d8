package org.sami.ui.map;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.sami.spn.value.GeoPoint;

/**
 * The outlines in a GeoJSON document (RFC 7946).
 *
 * @param lines lines, each two points or more
 * @param polygons their rings, the outer one first
 */
record GeoJson(List<List<GeoPoint>> lines, List<List<List<GeoPoint>>> polygons, List<NamedPoint> points) {
    private static final ObjectMapper JSON = new ObjectMapper();

    /** A point with its feature's name; empty text where it has none. */
    record NamedPoint(String name, GeoPoint at) {}

    /**
     * Reads a file, or a pipe; takes as long as it does, and ends when its thread is interrupted.
     *
     * @throws IOException with the file's name and what is wrong, if it is no GeoJSON
     */
    static GeoJson read(Path file) throws IOException {
        if (!Files.exists(file) || Files.isDirectory(file)) {
            throw new IOException("There is no map file " + file);
        }
        GeoJson found = new GeoJson(new ArrayList<>(), new ArrayList<>(), new ArrayList<>());
        try (InputStream text = Files.newInputStream(file)) {
            found.take(JSON.readTree(text), "");
        } catch (JsonProcessingException e) {
            throw new IOException(file + " is no JSON: " + e.getOriginalMessage(), e);
        } catch (IllegalArgumentException e) {
            throw new IOException(file + " is no GeoJSON: " + e.getMessage(), e);
        }
        return found;
    }

    private void take(JsonNode node, String name) {
        String type = node.path("type").asText("");
        JsonNode at = node.path("coordinates");
        switch (type) {
            case "FeatureCollection" -> node.path("features").forEach(feature -> take(feature, ""));
            case "GeometryCollection" -> node.path("geometries").forEach(part -> take(part, name));
            case "Feature" -> {
                if (!node.path("geometry").isNull()) {
                    take(
                            node.path("geometry"),
                            node.path("properties").path("name").asText(""));
                }
            }
            case "Point" -> points.add(new NamedPoint(name, point(at)));
            case "MultiPoint" -> at.forEach(each -> points.add(new NamedPoint(name, point(each))));
            case "LineString" -> lines.add(line(at));
            case "MultiLineString" -> at.forEach(each -> lines.add(line(each)));
            case "Polygon" -> polygons.add(rings(at));
            case "MultiPolygon" -> at.forEach(each -> polygons.add(rings(each)));
            default -> throw new IllegalArgumentException("'" + type + "' is no type of it");
        }
    }

    private static List<List<GeoPoint>> rings(JsonNode at) {
        List<List<GeoPoint>> rings = new ArrayList<>();
        at.forEach(ring -> rings.add(line(ring)));
        if (rings.isEmpty()) {
            throw new IllegalArgumentException("a polygon has no ring");
        }
        return rings;
    }

    private static List<GeoPoint> line(JsonNode at) {
        List<GeoPoint> points = new ArrayList<>();
        at.forEach(each -> points.add(point(each)));
        if (points.size() < 2) {
            throw new IllegalArgumentException("a line has two points or more, not " + at);
        }
        return points;
    }

    /** Longitude comes first in GeoJSON. */
    private static GeoPoint point(JsonNode at) {
        if (!at.path(0).isNumber() || !at.path(1).isNumber()) {
            throw new IllegalArgumentException("a position is [longitude, latitude], not " + at);
        }
        return GeoPoint.of(at.path(1).asDouble(), at.path(0).asDouble());
    }
}
