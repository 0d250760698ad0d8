package org.sami.crw.log;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.math.BigDecimal;
import java.math.RoundingMode;
import org.sami.spn.value.GeoPoint;

/**
 * The track as GeoJSON (RFC 7946): one feature a stretch, a line, or a point where the boat never moved. Thinned as for
 * drawing; {@code tracks.csv} has every position.
 */
final class TrackGeoJson {
    private static final ObjectMapper MAPPER = new ObjectMapper();

    private TrackGeoJson() {}

    static String text(LogSummary summary) {
        ObjectNode json = JsonNodeFactory.instance.objectNode().put("type", "FeatureCollection");
        ArrayNode features = json.putArray("features");
        summary.poses().stretches().forEach(stretch -> feature(features.addObject(), "pose", stretch));
        summary.fixes().stretches().forEach(stretch -> feature(features.addObject(), "gps", stretch));
        try {
            return MAPPER.writeValueAsString(json) + "\n";
        } catch (JsonProcessingException e) {
            throw new IllegalStateException("a tree of plain nodes was not writable", e);
        }
    }

    private static void feature(ObjectNode feature, String source, TrackSegment stretch) {
        feature.put("type", "Feature");
        feature.putObject("properties")
                .put("source", source)
                .put("stretch", stretch.number())
                .put("startSeconds", BigDecimal.valueOf(stretch.startMillis(), 3))
                .put("endSeconds", BigDecimal.valueOf(stretch.endMillis(), 3))
                .put("positions", stretch.positions())
                .put("distanceM", decimal(stretch.distanceM(), 1));
        ObjectNode geometry = feature.putObject("geometry");
        if (stretch.points().size() == 1) {
            geometry.put("type", "Point");
            position(geometry.putArray("coordinates"), stretch.first());
        } else {
            geometry.put("type", "LineString");
            ArrayNode line = geometry.putArray("coordinates");
            stretch.points().forEach(point -> position(line.addArray(), point));
        }
    }

    private static void position(ArrayNode coordinates, GeoPoint point) {
        coordinates.add(decimal(point.lonDeg(), 7)).add(decimal(point.latDeg(), 7));
    }

    private static BigDecimal decimal(double value, int digits) {
        return BigDecimal.valueOf(value).setScale(digits, RoundingMode.HALF_UP);
    }
}
