package org.sami.ui.value;

import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Collectors;
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

/** Any value in a few words for people: what a row, a cell or a tooltip says of it. Not to be read back. */
public final class ValueSummary {
    private static final int MOST_LISTED = 4;

    private ValueSummary() {}

    /** A value in one line. */
    public static String of(Value value) {
        if (value instanceof TextValue text) {
            return text.value();
        }
        if (value instanceof BooleanValue flag) {
            return flag.value() ? "yes" : "no";
        }
        if (value instanceof IntegerValue || value instanceof RealValue) {
            return new NumberText(false, "").write(value);
        }
        if (value instanceof DurationValue duration) {
            return DurationText.write(duration.millis());
        }
        if (value instanceof EnumValue constant) {
            return ofConstant(constant.constant());
        }
        if (value instanceof GeoPoint || value instanceof GeoPath || value instanceof GeoArea) {
            return ofPlace(value);
        }
        return value instanceof ListValue || value instanceof MapValue || value instanceof RecordValue
                ? ofParts(value)
                : ofName(value);
    }

    /** The constant of an enumeration: {@code RELEVANT_PROXIES} becomes {@code Relevant proxies}. */
    public static String ofConstant(String constant) {
        String words = constant.replace('_', ' ').toLowerCase(Locale.ROOT);
        return words.isEmpty() ? constant : words.substring(0, 1).toUpperCase(Locale.ROOT) + words.substring(1);
    }

    private static String ofName(Value value) {
        if (value instanceof ProxyValue proxy) {
            return proxy.proxy();
        }
        if (value instanceof TaskId task) {
            return task.name();
        }
        return value instanceof VariableReference variable ? variable.variable() : ((PlanReference) value).plan();
    }

    private static String ofPlace(Value value) {
        if (value instanceof GeoPoint point) {
            return String.format(Locale.ROOT, "%.5f, %.5f", point.latDeg(), point.lonDeg());
        }
        if (value instanceof GeoPath path) {
            return "path of " + count(path.points().size(), "point");
        }
        GeoArea area = (GeoArea) value;
        return "area of " + count(area.outline().size(), "corner")
                + (area.holes().isEmpty() ? "" : " with " + count(area.holes().size(), "hole"));
    }

    private static String ofParts(Value value) {
        if (value instanceof ListValue list) {
            return ofList(list.items());
        }
        Map<?, Value> parts = value instanceof MapValue map ? map.entries() : ((RecordValue) value).fields();
        String text = parts.entrySet().stream()
                .limit(MOST_LISTED)
                .map(part -> (part.getKey() instanceof Value key ? of(key) : ValueField.words((String) part.getKey()))
                        + ": " + of(part.getValue()))
                .collect(Collectors.joining("; "));
        return text.isEmpty() ? "nothing" : text + (parts.size() > MOST_LISTED ? "; …" : "");
    }

    private static String ofList(List<Value> items) {
        if (items.isEmpty()) {
            return "none";
        }
        if (items.size() > 1 && items.stream().allMatch(GeoPoint.class::isInstance)) {
            return count(items.size(), "point");
        }
        String text = items.stream().limit(MOST_LISTED).map(ValueSummary::of).collect(Collectors.joining(", "));
        return items.size() > MOST_LISTED ? text + " and " + (items.size() - MOST_LISTED) + " more" : text;
    }

    private static String count(int number, String what) {
        return number + " " + what + (number == 1 ? "" : "s");
    }
}
