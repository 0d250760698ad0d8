package org.sami.crw.decision;

import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.regex.Pattern;
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

/** Values in short words, for people. Nobody reads them back. */
public final class ValueWords {
    private static final int ITEMS_SHOWN = 4;
    private static final String NAME = "name";
    private static final Map<String, String> UNITS = Map.of("M", "m", "Mps", "m/s", "S", "s", "Deg", "\u00b0");
    private static final Pattern BEFORE_CAPITAL = Pattern.compile("(?<=[a-z])(?=[A-Z])");

    private ValueWords() {}

    /** What names an option: a record's field {@code name}, else what of it can be said in a word or two. */
    static String label(Value value) {
        if (!(value instanceof RecordValue record)) {
            return of(value);
        }
        return record.fields().get(NAME) instanceof TextValue name ? name.value() : parts(record);
    }

    /** What else can be said of an option that has a name. */
    static String detail(Value value) {
        return value instanceof RecordValue record && record.fields().get(NAME) instanceof TextValue
                ? parts(record)
                : "";
    }

    /** The fields that can be said in a word or two; a path or a map cannot. */
    private static String parts(RecordValue record) {
        return record.fields().entrySet().stream()
                .filter(field -> !(field.getValue() instanceof MapValue)
                        && !field.getKey().equals(NAME)
                        && !of(field.getValue()).isEmpty())
                .map(field -> part(field.getKey(), field.getValue()))
                .collect(Collectors.joining(", "));
    }

    /** A field with its name in words; the unit of a number is the end of its name, such as {@code totalLengthM}. */
    private static String part(String name, Value value) {
        if (!(value instanceof RealValue real)) {
            return words(name) + " " + of(value);
        }
        for (Map.Entry<String, String> unit : UNITS.entrySet()) {
            if (name.length() > unit.getKey().length() && name.endsWith(unit.getKey())) {
                String bare = name.substring(0, name.length() - unit.getKey().length());
                return words(bare) + " " + rounded(real.value()) + " " + unit.getValue();
            }
        }
        return words(name) + " " + rounded(real.value());
    }

    private static String words(String name) {
        return BEFORE_CAPITAL.matcher(name).replaceAll(" ").toLowerCase(Locale.ROOT);
    }

    private static String rounded(double value) {
        return value == Math.rint(value) ? String.valueOf((long) value) : String.format(Locale.ROOT, "%.1f", value);
    }

    /** A value; of a long one how much there is of it. */
    public static String of(Value value) {
        if (value instanceof ListValue list) {
            return items(list.items());
        }
        if (value instanceof GeoPath path) {
            return items(path.points());
        }
        if (value instanceof GeoArea area) {
            return area(area);
        }
        if (value instanceof MapValue map) {
            return map.entries().entrySet().stream()
                    .limit(ITEMS_SHOWN)
                    .map(e -> of(e.getKey()) + ": " + of(e.getValue()))
                    .collect(Collectors.joining(", "));
        }
        if (value instanceof RecordValue record) {
            return record.type() + " " + record.fields().keySet();
        }
        return scalar(value);
    }

    private static String items(List<? extends Value> items) {
        if (items.size() > ITEMS_SHOWN) {
            Value first = items.get(0);
            return items.size()
                    + (first instanceof GeoPoint ? " points" : first instanceof GeoArea ? " areas" : " values");
        }
        return items.stream().map(ValueWords::of).collect(Collectors.joining(", "));
    }

    /** How many corners it has, and the middle of them. */
    private static String area(GeoArea area) {
        double latDeg =
                area.outline().stream().mapToDouble(GeoPoint::latDeg).average().orElse(0);
        double lonDeg =
                area.outline().stream().mapToDouble(GeoPoint::lonDeg).average().orElse(0);
        int holes = area.holes().size();
        return "an area of " + area.outline().size() + " corners around " + scalar(GeoPoint.of(latDeg, lonDeg))
                + (holes == 0 ? "" : ", with " + holes + (holes == 1 ? " hole" : " holes"));
    }

    private static String scalar(Value value) {
        if (value instanceof GeoPoint point) {
            return String.format(Locale.ROOT, "%.6f/%.6f", point.latDeg(), point.lonDeg());
        }
        if (value instanceof DurationValue duration) {
            return duration.millis() / 1000.0 + " s";
        }
        if (value instanceof TextValue text) {
            return text.value();
        }
        if (value instanceof RealValue real) {
            return String.valueOf(real.value());
        }
        if (value instanceof IntegerValue integer) {
            return String.valueOf(integer.value());
        }
        if (value instanceof BooleanValue truth) {
            return String.valueOf(truth.value());
        }
        return named(value);
    }

    private static String named(Value value) {
        if (value instanceof ProxyValue proxy) {
            return proxy.proxy();
        }
        if (value instanceof EnumValue constant) {
            return constant.constant();
        }
        if (value instanceof TaskId task) {
            return task.name();
        }
        if (value instanceof VariableReference variable) {
            return variable.variable();
        }
        return value instanceof PlanReference plan ? plan.plan() : value.toString();
    }
}
