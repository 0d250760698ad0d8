package org.sami.spn.json;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.BooleanNode;
import com.fasterxml.jackson.databind.node.DoubleNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.LongNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import com.fasterxml.jackson.databind.node.TextNode;
import java.time.Duration;
import java.util.List;
import org.sami.spn.value.BooleanValue;
import org.sami.spn.value.DurationValue;
import org.sami.spn.value.EnumValue;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPath;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.IntegerValue;
import org.sami.spn.value.PlanReference;
import org.sami.spn.value.ProxyValue;
import org.sami.spn.value.RealValue;
import org.sami.spn.value.TaskId;
import org.sami.spn.value.TextValue;
import org.sami.spn.value.Value;
import org.sami.spn.value.VariableReference;

/** Writes values of types without parameters, and constants of enumerations, in the form that {@link SimpleValueReader} reads back. */
final class SimpleValueWriter {
    private static final JsonNodeFactory NODES = JsonNodeFactory.instance;
    private static final double EXACT_WHOLE = 1e15;

    private SimpleValueWriter() {}

    /** The node of a value that is no list, map or record. */
    static JsonNode write(Value value) {
        if (value instanceof BooleanValue v) {
            return BooleanNode.valueOf(v.value());
        } else if (value instanceof IntegerValue v) {
            return LongNode.valueOf(v.value());
        } else if (value instanceof RealValue v) {
            return number(v.value());
        } else if (value instanceof TextValue v) {
            return TextNode.valueOf(v.value());
        } else if (value instanceof DurationValue v) {
            return TextNode.valueOf(Duration.ofMillis(v.millis()).toString());
        } else if (value instanceof EnumValue v) {
            return TextNode.valueOf(v.constant());
        } else if (value instanceof ProxyValue v) {
            return TextNode.valueOf(v.proxy());
        } else if (value instanceof VariableReference v) {
            return TextNode.valueOf(v.variable());
        } else if (value instanceof PlanReference v) {
            return TextNode.valueOf(v.plan());
        } else if (value instanceof TaskId v) {
            return NODES.objectNode().put("mission", v.mission()).put("name", v.name());
        }
        return geo(value);
    }

    private static JsonNode geo(Value value) {
        if (value instanceof GeoPoint v) {
            return point(v);
        } else if (value instanceof GeoPath v) {
            return points(v.points());
        } else if (value instanceof GeoArea v) {
            ObjectNode area = NODES.objectNode();
            area.set("outline", points(v.outline()));
            if (!v.holes().isEmpty()) {
                ArrayNode holes = area.putArray("holes");
                v.holes().forEach(h -> holes.add(points(h)));
            }
            return area;
        }
        throw new IllegalArgumentException("The value does not fit its type: " + value);
    }

    private static ObjectNode point(GeoPoint p) {
        ObjectNode node = NODES.objectNode();
        node.set("lat", number(p.latDeg()));
        node.set("lon", number(p.lonDeg()));
        if (Double.compare(p.altM(), 0.0) != 0) {
            node.set("alt", number(p.altM()));
        }
        return node;
    }

    private static ArrayNode points(List<GeoPoint> points) {
        ArrayNode array = NODES.arrayNode();
        points.forEach(p -> array.add(point(p)));
        return array;
    }

    /** A real number; a whole one is written without a point, and read back as the same real number. */
    static JsonNode number(double value) {
        boolean whole = value == Math.rint(value) && Math.abs(value) < EXACT_WHOLE && Double.compare(value, -0.0) != 0;
        return whole ? LongNode.valueOf((long) value) : DoubleNode.valueOf(value);
    }
}
