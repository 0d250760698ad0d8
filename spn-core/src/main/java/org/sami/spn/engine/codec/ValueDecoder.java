package org.sami.spn.engine.codec;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.sami.spn.value.BooleanValue;
import org.sami.spn.value.DurationValue;
import org.sami.spn.value.EnumValue;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPath;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.IntegerValue;
import org.sami.spn.value.ListValue;
import org.sami.spn.value.MapValue;
import org.sami.spn.value.PlanReference;
import org.sami.spn.value.ProxyValue;
import org.sami.spn.value.RealValue;
import org.sami.spn.value.RecordValue;
import org.sami.spn.value.TaskId;
import org.sami.spn.value.TextValue;
import org.sami.spn.value.Value;
import org.sami.spn.value.VariableReference;

/** Reads what {@link ValueEncoder} wrote. */
public class ValueDecoder {
    private final ByteBuffer in;

    ValueDecoder(byte[] bytes) {
        this.in = ByteBuffer.wrap(bytes);
    }

    public int integer() {
        return in.getInt();
    }

    public long number() {
        return in.getLong();
    }

    public double real() {
        return Double.longBitsToDouble(in.getLong());
    }

    public boolean flag() {
        return in.get() != 0;
    }

    public int tag() {
        return in.get();
    }

    public String text() {
        byte[] utf = new byte[size()];
        in.get(utf);
        return new String(utf, StandardCharsets.UTF_8);
    }

    /** A size that the rest of the bytes can hold. */
    public int size() {
        int n = integer();
        if (n < 0 || n > in.remaining()) {
            throw new IllegalArgumentException("The bytes end before what they announce");
        }
        return n;
    }

    public List<String> texts() {
        List<String> result = new ArrayList<>();
        for (int i = size(); i > 0; i--) {
            result.add(text());
        }
        return result;
    }

    public Map<String, Value> values() {
        Map<String, Value> result = new LinkedHashMap<>();
        for (int i = size(); i > 0; i--) {
            String key = text();
            result.put(key, value());
        }
        return result;
    }

    public Optional<Value> optional() {
        return flag() ? Optional.of(value()) : Optional.empty();
    }

    public List<Value> valueList() {
        List<Value> result = new ArrayList<>();
        for (int i = size(); i > 0; i--) {
            result.add(value());
        }
        return result;
    }

    public Value value() {
        int tag = tag();
        return switch (tag) {
            case 0 -> new BooleanValue(flag());
            case 1 -> new IntegerValue(number());
            case 2 -> new RealValue(real());
            case 3 -> new TextValue(text());
            case 4 -> new DurationValue(number());
            case 5 -> new EnumValue(text(), text());
            case 6 -> new RecordValue(text(), values());
            case 7 -> new ListValue(valueList());
            case 8 -> map();
            case 9 -> new ProxyValue(text());
            case 10 -> task();
            case 11 -> point();
            case 12 -> new GeoPath(points());
            case 13 -> area();
            case 14 -> new VariableReference(text());
            case 15 -> new PlanReference(text());
            default -> throw new IllegalArgumentException("No kind of value: " + tag);
        };
    }

    private Value map() {
        Map<Value, Value> entries = new LinkedHashMap<>();
        for (int i = size(); i > 0; i--) {
            Value key = value();
            entries.put(key, value());
        }
        return new MapValue(entries);
    }

    private Value task() {
        String name = text();
        return new TaskId(number(), name);
    }

    private GeoPoint point() {
        return new GeoPoint(real(), real(), real());
    }

    private List<GeoPoint> points() {
        List<GeoPoint> result = new ArrayList<>();
        for (int i = size(); i > 0; i--) {
            result.add(point());
        }
        return result;
    }

    private Value area() {
        List<GeoPoint> outline = points();
        List<List<GeoPoint>> holes = new ArrayList<>();
        for (int i = size(); i > 0; i--) {
            holes.add(points());
        }
        return new GeoArea(outline, holes);
    }
}
