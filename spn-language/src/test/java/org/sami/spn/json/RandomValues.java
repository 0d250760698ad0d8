package org.sami.spn.json;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import org.sami.spn.value.BooleanValue;
import org.sami.spn.value.DurationValue;
import org.sami.spn.value.EnumValue;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPath;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.IntegerValue;
import org.sami.spn.value.ListValue;
import org.sami.spn.value.MapValue;
import org.sami.spn.value.NamedType;
import org.sami.spn.value.PlanReference;
import org.sami.spn.value.ProxyValue;
import org.sami.spn.value.RealValue;
import org.sami.spn.value.RecordValue;
import org.sami.spn.value.TaskId;
import org.sami.spn.value.TextValue;
import org.sami.spn.value.Value;
import org.sami.spn.value.ValueType;
import org.sami.spn.value.VariableReference;

/** Seeded random types and values of them, with a fondness for edges. */
final class RandomValues {
    static final Map<String, NamedType> TYPES = Map.of(
            "Colour", new NamedType.Enumeration("Colour", List.of("RED", "GREEN")),
            "Pair", new NamedType.RecordType("Pair", fields()));

    private static final double[] REALS = {
        0, -0.0, 1, -1, 0.1, 1e-7, 1e300, Double.MIN_VALUE, Double.MAX_VALUE, 1e15, 1.2345678901234568E+17, 3.0e10
    };
    private static final String[] TEXTS = {"", "a", "Größe \"x\"\n\t\\", "\u0000\u2028", "a/b~c", "🚤", "null", "1"};

    private final Random random;

    RandomValues(long seed) {
        random = new Random(seed);
    }

    private static Map<String, ValueType> fields() {
        Map<String, ValueType> fields = new LinkedHashMap<>();
        fields.put("left", ValueType.Simple.REAL);
        fields.put("right", new ValueType.ListOf(ValueType.Simple.POINT));
        return fields;
    }

    int number(int bound) {
        return random.nextInt(bound);
    }

    ValueType type(int depth) {
        int pick = random.nextInt(depth > 0 ? 18 : 15);
        ValueType.Simple[] simple = ValueType.Simple.values();
        if (pick < simple.length) {
            return simple[pick];
        }
        return switch (pick - simple.length) {
            case 0 -> new ValueType.Named("Colour");
            case 1 -> new ValueType.Named("Pair");
            case 2 -> new ValueType.ListOf(type(depth - 1));
            default -> new ValueType.MapOf(type(depth - 1), type(depth - 1));
        };
    }

    Value value(ValueType type) {
        if (type instanceof ValueType.ListOf list) {
            return new ListValue(many(list.element()));
        } else if (type instanceof ValueType.MapOf map) {
            Map<Value, Value> entries = new LinkedHashMap<>();
            many(map.key()).forEach(k -> entries.put(k, value(map.value())));
            return new MapValue(entries);
        } else if (type instanceof ValueType.Named named) {
            return named(named.name());
        }
        return simple((ValueType.Simple) type);
    }

    private Value named(String name) {
        if (name.equals("Colour")) {
            return new EnumValue("Colour", random.nextBoolean() ? "RED" : "GREEN");
        }
        Map<String, Value> fields = new LinkedHashMap<>();
        fields().forEach((field, type) -> fields.put(field, value(type)));
        return new RecordValue("Pair", fields);
    }

    private Value simple(ValueType.Simple type) {
        return switch (type) {
            case BOOLEAN -> new BooleanValue(random.nextBoolean());
            case INTEGER -> new IntegerValue(random.nextBoolean() ? random.nextLong() : random.nextInt(10));
            case REAL -> new RealValue(real());
            case TEXT -> new TextValue(text());
            case DURATION -> new DurationValue(random.nextBoolean() ? random.nextInt(100_000) : Long.MAX_VALUE);
            case PROXY -> new ProxyValue(text());
            case TASK -> new TaskId(random.nextLong(), "t" + text());
            case POINT -> point();
            case PATH -> new GeoPath(points(0));
            case AREA -> new GeoArea(points(3), List.of(points(0)));
            case VARIABLE -> new VariableReference("@" + "v" + text());
            case PLAN -> new PlanReference(text());
            case ANY -> value(type(1));
        };
    }

    double real() {
        return random.nextBoolean() ? REALS[random.nextInt(REALS.length)] : random.nextGaussian() * 1e6;
    }

    String text() {
        return TEXTS[random.nextInt(TEXTS.length)];
    }

    GeoPoint point() {
        double alt = random.nextInt(3) == 0 ? REALS[random.nextInt(5)] : 0;
        return new GeoPoint(random.nextDouble() * 180 - 90, random.nextInt(361) - 180, alt);
    }

    private List<GeoPoint> points(int least) {
        List<GeoPoint> points = new ArrayList<>();
        for (int n = least + random.nextInt(3); n > 0; n--) {
            points.add(point());
        }
        return points;
    }

    private List<Value> many(ValueType type) {
        List<Value> values = new ArrayList<>();
        for (int n = random.nextInt(4); n > 0; n--) {
            values.add(value(type));
        }
        return values;
    }
}
