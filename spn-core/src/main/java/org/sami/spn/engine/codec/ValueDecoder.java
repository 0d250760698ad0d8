package org.sami.spn.engine.codec;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
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
public final class ValueDecoder {
    private final ProtocolDecoder in;

    public ValueDecoder(ProtocolDecoder in) {
        this.in = in;
    }

    public Value read() {
        int tag = in.tag();
        return switch (tag) {
            case 0 -> new BooleanValue(in.flag());
            case 1 -> new IntegerValue(in.number());
            case 2 -> new RealValue(in.real());
            case 3 -> new TextValue(in.text());
            case 4 -> new DurationValue(in.number());
            case 5 -> new EnumValue(in.text(), in.text());
            case 6 -> new RecordValue(in.text(), in.values());
            case 7 -> new ListValue(in.valueList());
            case 8 -> map();
            case 9 -> new ProxyValue(in.text());
            case 10 -> task();
            case 11 -> point();
            case 12 -> new GeoPath(points());
            case 13 -> area();
            case 14 -> new VariableReference(in.text());
            case 15 -> new PlanReference(in.text());
            default -> throw new IllegalArgumentException("No kind of value: " + tag);
        };
    }

    private Value map() {
        Map<Value, Value> entries = new LinkedHashMap<>();
        for (int i = in.size(); i > 0; i--) {
            Value key = read();
            entries.put(key, read());
        }
        return new MapValue(entries);
    }

    private Value task() {
        String name = in.text();
        return new TaskId(in.number(), name);
    }

    private GeoPoint point() {
        return new GeoPoint(in.real(), in.real(), in.real());
    }

    private List<GeoPoint> points() {
        List<GeoPoint> result = new ArrayList<>();
        for (int i = in.size(); i > 0; i--) {
            result.add(point());
        }
        return result;
    }

    private Value area() {
        List<GeoPoint> outline = points();
        List<List<GeoPoint>> holes = new ArrayList<>();
        for (int i = in.size(); i > 0; i--) {
            holes.add(points());
        }
        return new GeoArea(outline, holes);
    }
}
