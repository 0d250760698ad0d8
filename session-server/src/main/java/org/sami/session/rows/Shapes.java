package org.sami.session.rows;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPath;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.ListValue;
import org.sami.spn.value.MapValue;
import org.sami.spn.value.ProxyValue;
import org.sami.spn.value.Value;

/** Values as shapes on a map; positions are {@code [lat,lon]} in degrees, rounded to 1e-7 (1 cm). */
final class Shapes {
    /** The most points of one line; more are left out. */
    static final int MOST_POINTS = 2000;

    private static final int MOST_PARTS = 100;
    private static final double ROUNDING = 1e7;
    private static final JsonNodeFactory NODES = JsonNodeFactory.instance;

    private Shapes() {}

    static double rounded(double degrees) {
        return Math.round(degrees * ROUNDING) / ROUNDING;
    }

    static ArrayNode point(GeoPoint point) {
        return NODES.arrayNode().add(rounded(point.latDeg())).add(rounded(point.lonDeg()));
    }

    static ArrayNode points(List<GeoPoint> points) {
        ArrayNode line = NODES.arrayNode();
        points.stream().limit(MOST_POINTS).map(Shapes::point).forEach(line::add);
        return line;
    }

    static ObjectNode area(GeoArea area) {
        ObjectNode shape = NODES.objectNode();
        shape.set("area", points(area.outline()));
        if (!area.holes().isEmpty()) {
            ArrayNode holes = shape.putArray("holes");
            area.holes().stream().limit(MOST_PARTS).map(Shapes::points).forEach(holes::add);
        }
        return shape;
    }

    static ObjectNode path(List<GeoPoint> points) {
        ObjectNode shape = NODES.objectNode();
        shape.set("path", points(points));
        return shape;
    }

    static ObjectNode place(GeoPoint point) {
        ObjectNode shape = NODES.objectNode();
        shape.set("point", point(point));
        return shape;
    }

    /** The shape of a value; empty for one without a place. */
    static Optional<ObjectNode> of(Value value) {
        if (value instanceof GeoPoint point) {
            return Optional.of(place(point));
        } else if (value instanceof GeoPath path) {
            return Optional.of(path(path.points()));
        } else if (value instanceof GeoArea area) {
            return Optional.of(area(area));
        } else if (value instanceof ListValue list) {
            ArrayNode many = NODES.arrayNode();
            list.items().stream().limit(MOST_PARTS).forEach(one -> add(many, "", one));
            return many(many);
        } else if (value instanceof MapValue map) {
            ArrayNode many = NODES.arrayNode();
            for (Map.Entry<Value, Value> entry : map.entries().entrySet()) {
                if (many.size() < MOST_PARTS) {
                    add(many, entry.getKey() instanceof ProxyValue boat ? boat.proxy() : "", entry.getValue());
                }
            }
            return many(many);
        }
        return Optional.empty();
    }

    private static void add(ArrayNode many, String label, Value value) {
        of(value).ifPresent(shape -> many.addObject().put("label", label).set("shape", shape));
    }

    private static Optional<ObjectNode> many(ArrayNode many) {
        if (many.isEmpty()) {
            return Optional.empty();
        }
        ObjectNode shape = NODES.objectNode();
        shape.set("many", many);
        return Optional.of(shape);
    }
}
