package org.sami.ui.value;

import java.util.ArrayList;
import java.util.Collections;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import org.sami.spn.value.DurationValue;
import org.sami.spn.value.GeoPath;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.IntegerValue;
import org.sami.spn.value.ListValue;
import org.sami.spn.value.MapValue;
import org.sami.spn.value.NaturalOrder;
import org.sami.spn.value.ProxyValue;
import org.sami.spn.value.RealValue;
import org.sami.spn.value.RecordValue;
import org.sami.spn.value.TextValue;
import org.sami.spn.value.Value;

/**
 * What of a solution can be compared in a table: a figure for each field that is a number, duration or text, and for each map how many
 * entries it has and what stands in them. The unit of a number is the end of its field's name: {@code totalLengthM} is in metres.
 *
 * @param figures texts by label, in order
 * @param lines what each entry of a map says, such as a robot and the length of its path
 */
record Figures(Map<String, String> figures, Map<String, String> lines) {
    private static final Map<String, String> UNITS = Map.of("M", "m", "Mps", "m/s", "S", "s", "Deg", "°", "M2", "m²");

    private static final int LONGEST = 14; // of what has its place in a column

    Figures {
        figures = Collections.unmodifiableMap(new LinkedHashMap<>(figures));
        lines = Collections.unmodifiableMap(new LinkedHashMap<>(lines));
    }

    /** The figures of a solution of which no ways are known. */
    static Figures of(Value solution) {
        return of(solution, Map.of());
    }

    /**
     * The figures of a solution.
     *
     * @param ways on which robots would go along their paths, from where they are, as far as they are known
     */
    static Figures of(Value solution, Map<RobotPath, List<GeoPoint>> ways) {
        Map<String, String> figures = new LinkedHashMap<>();
        Map<String, String> lines = new LinkedHashMap<>();
        if (solution instanceof RecordValue fields) {
            fields.fields().forEach((name, value) -> field(name, value, ways, figures, lines));
        } else if (solution instanceof MapValue map) {
            field("entries", map, ways, figures, lines);
        } else {
            figures.put("Value", ValueSummary.of(solution));
        }
        return new Figures(figures, lines);
    }

    private static void field(
            String name,
            Value value,
            Map<RobotPath, List<GeoPoint>> ways,
            Map<String, String> figures,
            Map<String, String> lines) {
        if (value instanceof MapValue map) {
            if (!map.entries().isEmpty()) {
                figures.put(ValueField.words(name), String.valueOf(map.entries().size()));
                keys(map)
                        .forEach(key -> lines.merge(
                                ValueSummary.of(key),
                                inWords(
                                        key,
                                        Objects.requireNonNull(map.entries().get(key)),
                                        ways),
                                (a, b) -> a.equals(b) ? a : a + ", " + b));
            }
        } else if (value instanceof ListValue list) {
            figures.put(
                    ValueField.words(name),
                    list.items().isEmpty()
                            ? "none"
                            : String.valueOf(list.items().size()));
        } else if (value instanceof RealValue real) {
            Optional<String> ending =
                    UNITS.keySet().stream().filter(name::endsWith).findFirst();
            String label = ending.map(end -> name.substring(0, name.length() - end.length()))
                    .orElse(name);
            figures.put(
                    ValueField.words(label),
                    String.format(Locale.ROOT, "%.1f", real.value())
                            + ending.map(end -> " " + UNITS.get(end)).orElse(""));
        } else if (value instanceof IntegerValue || value instanceof DurationValue || isWords(value)) {
            figures.put(ValueField.words(name), ValueSummary.of(value));
        }
    }

    /** Robots by their names; all else, such as tasks, as it is in the map. */
    private static List<Value> keys(MapValue map) {
        List<Value> keys = new ArrayList<>(map.entries().keySet());
        if (keys.stream().allMatch(ProxyValue.class::isInstance)) {
            keys.sort(Comparator.comparing(key -> ((ProxyValue) key).proxy(), NaturalOrder.INSTANCE));
        }
        return keys;
    }

    private static boolean isWords(Value value) {
        return value instanceof TextValue text && !text.value().isBlank();
    }

    private static String inWords(Value key, Value value, Map<RobotPath, List<GeoPoint>> ways) {
        if (!(value instanceof GeoPath path)) {
            return ValueSummary.of(value);
        }
        Optional<List<GeoPoint>> way = key instanceof ProxyValue robot
                ? Optional.ofNullable(ways.get(new RobotPath(robot.proxy(), path)))
                : Optional.empty();
        return Places.pathInWords(path, way);
    }

    /** The paths that a solution has for robots. */
    static List<RobotPath> paths(Value solution) {
        List<MapValue> maps = solution instanceof MapValue map
                ? List.of(map)
                : solution instanceof RecordValue fields
                        ? fields.fields().values().stream()
                                .filter(MapValue.class::isInstance)
                                .map(MapValue.class::cast)
                                .toList()
                        : List.of();
        List<RobotPath> paths = new ArrayList<>();
        for (MapValue map : maps) {
            map.entries().forEach((key, value) -> {
                if (key instanceof ProxyValue robot && value instanceof GeoPath path) {
                    paths.add(new RobotPath(robot.proxy(), path));
                }
            });
        }
        return paths;
    }

    /** The labels that stand in a table of several solutions: those whose text is short in all, in the order in which they come first. */
    static List<String> compared(List<Figures> solutions) {
        Set<String> labels = solutions.stream()
                .flatMap(each -> each.figures().keySet().stream())
                .collect(Collectors.toCollection(LinkedHashSet::new));
        return labels.stream()
                .filter(label -> solutions.stream()
                        .allMatch(each -> each.figures().getOrDefault(label, "").length() <= LONGEST))
                .toList();
    }
}
