package org.sami.crw.report.file;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.awt.Color;
import java.math.BigDecimal;
import java.math.RoundingMode;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.sami.crw.report.BoatResult;
import org.sami.crw.report.LocationResult;
import org.sami.crw.report.MapArea;
import org.sami.crw.report.MapNames;
import org.sami.crw.report.MapPath;
import org.sami.crw.report.MapPoint;
import org.sami.crw.report.RunReport;
import org.sami.crw.report.picture.MapColors;

/**
 * A run as GeoJSON (RFC 7946): a feature for each boat's track, path that a boat was given, location, area and point. Positions are WGS 84, longitude first;
 * {@code kind} says what a feature is. A track's {@code atS} are seconds of the run, one for each position, and {@code times} the same
 * in UTC where the run says when it began.
 */
final class GeoJsonFile {
    private static final JsonNodeFactory NODES = JsonNodeFactory.instance;
    private static final int DIGITS = 7;

    private final RunReport report;
    private final ArrayNode features = NODES.arrayNode();

    private GeoJsonFile(RunReport report) {
        this.report = report;
    }

    static String text(RunReport report) {
        try {
            return new ObjectMapper().writeValueAsString(new GeoJsonFile(report).collection()) + "\n";
        } catch (JsonProcessingException e) {
            throw new IllegalStateException("a tree of plain nodes was not writable", e);
        }
    }

    private ObjectNode collection() {
        for (int i = 0; i < report.boats().size(); i++) {
            track(report.boats().get(i), MapColors.color(report.boats().get(i).mark()));
        }
        report.map().paths().forEach(this::path);
        report.locations().forEach(this::location);
        MapNames.areas(report).forEach(this::area);
        report.header()
                .place()
                .quay()
                .ifPresent(quay -> point("quay", report.header().robots().say("quay"), quay));
        point("centre", "centre", report.header().place().centre());
        report.map().spots().forEach(spot -> point(spot.kind().words(), MapNames.of(spot), spot.at()));
        ObjectNode collection = NODES.objectNode().put("type", "FeatureCollection");
        collection.set("features", features);
        return collection;
    }

    /** A boat that was seen once has no line. */
    private void track(BoatResult boat, Color color) {
        if (boat.track().isEmpty()) {
            return;
        }
        ArrayNode line = NODES.arrayNode();
        ObjectNode properties = NODES.objectNode()
                .put("kind", "track")
                .put("name", boat.id())
                .put("stroke", String.format("#%06x", color.getRGB() & 0xFFFFFF));
        ArrayNode seconds = properties.putArray("atS");
        boat.track().forEach(p -> {
            line.add(position(p.latDeg(), p.lonDeg()));
            seconds.add(BigDecimal.valueOf(p.atMillis(), 3));
        });
        if (boat.flew()) { // a third coordinate would be a height above the ellipsoid
            ArrayNode heights = properties.putArray("altM");
            boat.track().forEach(p -> heights.add(BigDecimal.valueOf(Math.round(p.altM() * 100), 2)));
        }
        report.origin().ifPresent(origin -> {
            ArrayNode times = properties.putArray("times");
            boat.track().forEach(p -> times.add(origin.at(p.atMillis()).toString()));
        });
        boolean isLine = line.size() > 1;
        feature(isLine ? "LineString" : "Point", isLine ? line : (ArrayNode) line.get(0), properties);
    }

    /** What a boat was to do; a path of one point has no line. */
    private void path(MapPath path) {
        ArrayNode line = NODES.arrayNode();
        path.points().forEach(p -> line.add(position(p.latDeg(), p.lonDeg())));
        ObjectNode properties = NODES.objectNode()
                .put("kind", "path")
                .put("name", "path of " + path.boat())
                .put("boat", path.boat())
                .put("mission", path.mission())
                .put("atS", BigDecimal.valueOf(path.atMillis(), 3));
        if (!line.isEmpty()) {
            boolean isLine = line.size() > 1;
            feature(isLine ? "LineString" : "Point", isLine ? line : (ArrayNode) line.get(0), properties);
        }
    }

    private void location(LocationResult location) {
        ObjectNode properties = NODES.objectNode()
                .put("kind", "location")
                .put("name", "location " + location.number())
                .put("number", location.number())
                .put("visited", location.visited());
        location.visit()
                .ifPresent(visit -> properties
                        .put("visitedAtS", BigDecimal.valueOf(visit.atMillis(), 3))
                        .put("visitedBy", visit.boat()));
        properties.put("reported", location.reported().isPresent());
        feature("Point", position(location.latDeg(), location.lonDeg()), properties);
    }

    private void point(String kind, String name, MapPoint at) {
        feature(
                "Point",
                position(at.latDeg(), at.lonDeg()),
                NODES.objectNode().put("kind", kind).put("name", name));
    }

    private void area(MapArea area) {
        ArrayNode rings = NODES.arrayNode();
        rings.add(ring(area.outline(), true));
        area.holes().forEach(hole -> rings.add(ring(hole, false)));
        ObjectNode properties = NODES.objectNode()
                .put("kind", area.kind().words())
                .put("name", area.kind().words())
                .put(
                        "stroke",
                        String.format("#%06x", MapColors.area(area.kind()).getRGB() & 0xFFFFFF));
        feature("Polygon", rings, properties);
    }

    /** Closed, the outline counterclockwise and holes clockwise. */
    private static ArrayNode ring(List<MapPoint> points, boolean counterclockwise) {
        double twice = 0;
        for (int i = 0; i < points.size(); i++) {
            MapPoint a = points.get(i);
            MapPoint b = points.get((i + 1) % points.size());
            twice += a.eastM() * b.northM() - b.eastM() * a.northM();
        }
        List<MapPoint> ordered = new ArrayList<>(points);
        if (twice > 0 != counterclockwise) {
            Collections.reverse(ordered);
        }
        ordered.add(ordered.get(0));
        ArrayNode ring = NODES.arrayNode();
        ordered.forEach(p -> ring.add(position(p.latDeg(), p.lonDeg())));
        return ring;
    }

    private void feature(String geometry, ArrayNode coordinates, ObjectNode properties) {
        ObjectNode feature = features.addObject().put("type", "Feature");
        feature.putObject("geometry").put("type", geometry).set("coordinates", coordinates);
        feature.set("properties", properties);
    }

    private static ArrayNode position(double latDeg, double lonDeg) {
        return NODES.arrayNode().add(decimal(lonDeg)).add(decimal(latDeg));
    }

    private static BigDecimal decimal(double value) {
        return BigDecimal.valueOf(value).setScale(DIGITS, RoundingMode.HALF_UP);
    }
}
