package org.sami.spn.stepping;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.IntStream;
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
import org.sami.spn.value.ProxyValue;
import org.sami.spn.value.RealValue;
import org.sami.spn.value.RecordValue;
import org.sami.spn.value.TaskId;
import org.sami.spn.value.TextValue;
import org.sami.spn.value.Value;
import org.sami.spn.value.ValueType;
import org.sami.spn.vocabulary.Vocabulary;

/**
 * Makes up a small value of any type, for trying a plan without a particular value in mind: so many locations a list, one item any other
 * list, one entry a map or one for each robot or task, points a hundred metres apart. Maps of tasks to robots give each robot a task in turn.
 * The same type gives the same value.
 */
public final class SampleValues {
    private static final double SPACING_DEG = 0.001;

    private final Vocabulary vocabulary;
    private final List<String> robots;
    private final List<TaskId> tasks;
    private final int locations;

    /**
     * Samples that speak of these robots and tasks.
     *
     * @param locations how many points a list of points has
     */
    public SampleValues(Vocabulary vocabulary, List<String> robots, List<TaskId> tasks, int locations) {
        this.vocabulary = vocabulary;
        this.robots = List.copyOf(robots);
        this.tasks = List.copyOf(tasks);
        this.locations = locations;
    }

    /** A value of a type; empty where it would name a robot, a task, a plan or a variable and there is none to name. */
    public Optional<Value> of(ValueType type) {
        if (type instanceof ValueType.ListOf list && list.element() == ValueType.Simple.POINT) {
            return Optional.of(new ListValue(IntStream.range(0, locations)
                    .mapToObj(i -> (Value) point(0, i))
                    .toList()));
        } else if (type instanceof ValueType.ListOf list) {
            return of(list.element()).map(item -> new ListValue(List.of(item)));
        } else if (type instanceof ValueType.MapOf map) {
            return map(map);
        } else if (type instanceof ValueType.Named named) {
            return Optional.ofNullable(vocabulary.types().get(named.name())).flatMap(this::named);
        }
        return simple((ValueType.Simple) type);
    }

    private Optional<Value> simple(ValueType.Simple type) {
        return switch (type) {
            case BOOLEAN -> Optional.of(new BooleanValue(true));
            case INTEGER -> Optional.of(new IntegerValue(1));
            case REAL -> Optional.of(new RealValue(1));
            case TEXT, ANY -> Optional.of(new TextValue("sample"));
            case DURATION -> Optional.of(new DurationValue(1000));
            case PROXY -> robots.stream().findFirst().map(ProxyValue::new);
            case TASK -> tasks.stream().findFirst().map(task -> task);
            case POINT -> Optional.of(point(0, 0));
            case PATH -> Optional.of(new GeoPath(List.of(point(0, 0), point(0, 1))));
            case AREA -> Optional.of(new GeoArea(List.of(point(0, 0), point(0, 1), point(1, 1)), List.of()));
            case VARIABLE, PLAN -> Optional.empty();
        };
    }

    private static GeoPoint point(int north, int east) {
        return GeoPoint.of(north * SPACING_DEG, east * SPACING_DEG);
    }

    /** A map whose keys are robots or tasks has one entry for each. */
    private Optional<Value> map(ValueType.MapOf type) {
        List<Value> keys = new ArrayList<>();
        if (type.key() == ValueType.Simple.PROXY) {
            robots.forEach(robot -> keys.add(new ProxyValue(robot)));
        } else if (type.key() == ValueType.Simple.TASK) {
            keys.addAll(tasks);
        } else {
            of(type.key()).ifPresent(keys::add);
        }
        if (type.value() == ValueType.Simple.PROXY && !robots.isEmpty()) {
            Map<Value, Value> inTurn = new LinkedHashMap<>();
            keys.forEach(key -> inTurn.put(key, new ProxyValue(robots.get(inTurn.size() % robots.size()))));
            return Optional.of(new MapValue(inTurn));
        }
        return of(type.value()).map(value -> {
            Map<Value, Value> entries = new LinkedHashMap<>();
            keys.forEach(key -> entries.put(key, value));
            return new MapValue(entries);
        });
    }

    /** Why there is no sample of a type, in a few words. */
    String whyNone(ValueType type) {
        if (type == ValueType.Simple.PROXY) {
            return "there is no robot to name";
        }
        return type == ValueType.Simple.TASK
                ? "there is no task to name"
                : "values of type " + type + " are not made up";
    }

    private Optional<Value> named(NamedType type) {
        if (type instanceof NamedType.Enumeration enumeration) {
            return enumeration.constants().stream().findFirst().map(first -> new EnumValue(enumeration.name(), first));
        }
        NamedType.RecordType record = (NamedType.RecordType) type;
        Map<String, Value> fields = new LinkedHashMap<>();
        for (Map.Entry<String, ValueType> field : record.fields().entrySet()) {
            Optional<Value> value = of(field.getValue()).or(() -> empty(field.getValue()));
            if (value.isEmpty()) {
                return Optional.empty();
            }
            fields.put(field.getKey(), value.get());
        }
        return Optional.of(new RecordValue(record.name(), fields));
    }

    /** An empty list or map is a value too, where there is nothing to put into it. */
    private static Optional<Value> empty(ValueType type) {
        if (type instanceof ValueType.MapOf) {
            return Optional.of(new MapValue(Map.of()));
        }
        return type instanceof ValueType.ListOf ? Optional.of(new ListValue(List.of())) : Optional.empty();
    }
}
