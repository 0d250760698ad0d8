package org.sami.lessons.job;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.IntStream;
import org.sami.spn.engine.EngineView;
import org.sami.spn.json.ValueJson;
import org.sami.spn.protocol.Activation;
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
import org.sami.spn.vocabulary.EventType;
import org.sami.spn.vocabulary.FieldType;
import org.sami.spn.vocabulary.Vocabulary;

/**
 * Values that operator, robots and services of a hidden case give. They depend on who is asked what for the how-manieth time, and on what was
 * asked, never on ids or names of the plan: right plans get equal ones, and values of different questions differ. Services divide the
 * locations or tasks that they are asked about among the robots in turn.
 */
final class WorldValues {
    private static final double SPACING_DEG = 0.001;
    private static final double QUESTION_DEG = 0.01;
    private static final int QUESTIONS = 500;

    private final Vocabulary vocabulary;
    private final int locations;
    private final List<String> robots;
    private final List<TaskId> tasks;
    private final Map<String, List<GeoPoint>> ways;
    private final int salt;

    private WorldValues(
            Vocabulary vocabulary,
            int locations,
            List<String> robots,
            List<TaskId> tasks,
            Map<String, List<GeoPoint>> ways,
            int salt) {
        this.vocabulary = vocabulary;
        this.locations = locations;
        this.robots = robots;
        this.tasks = tasks;
        this.ways = ways;
        this.salt = salt;
    }

    /**
     * Values for what is asked of nobody in particular.
     *
     * @param question what is asked, in words that do not depend on the plan
     */
    static WorldValues asked(String question, EngineView view, int locations) {
        return new WorldValues(
                view.vocabulary(),
                locations,
                view.proxies(),
                List.of(),
                Map.of(),
                Math.floorMod(question.hashCode(), QUESTIONS));
    }

    /** Values for what an activation asks, of robots that are named in the answer. */
    static WorldValues answering(
            Activation asked, List<String> robots, String question, EngineView view, int locations) {
        List<TaskId> tasks = asked.tasks();
        Map<String, List<GeoPoint>> ways = new LinkedHashMap<>();
        robots.forEach(robot -> ways.put(robot, new ArrayList<>()));
        if (!robots.isEmpty()) {
            List<GeoPoint> points = points(asked, view);
            for (int i = 0; i < points.size(); i++) {
                ways.computeIfAbsent(robots.get(i % robots.size()), robot -> new ArrayList<>())
                        .add(points.get(i));
            }
            asked.values().values().forEach(value -> own(value, ways));
        }
        return new WorldValues(
                view.vocabulary(), locations, robots, tasks, ways, Math.floorMod(question.hashCode(), QUESTIONS));
    }

    private static List<GeoPoint> points(Activation asked, EngineView view) {
        List<GeoPoint> points = new ArrayList<>();
        for (TaskId task : asked.tasks()) {
            view.task(task).orElse(Map.of()).values().stream()
                    .filter(GeoPoint.class::isInstance)
                    .findFirst()
                    .ifPresent(point -> points.add((GeoPoint) point));
        }
        if (asked.tasks().isEmpty()) {
            for (Value value : asked.values().values()) {
                if (value instanceof ListValue list) {
                    list.items().stream()
                            .filter(GeoPoint.class::isInstance)
                            .forEach(point -> points.add((GeoPoint) point));
                }
            }
        }
        return points;
    }

    /** What was asked for each robot by itself is its own. */
    private static void own(Value value, Map<String, List<GeoPoint>> ways) {
        if (value instanceof MapValue map) {
            map.entries().forEach((key, item) -> {
                if (key instanceof ProxyValue robot && item instanceof GeoPoint point) {
                    Optional.ofNullable(ways.get(robot.proxy())).ifPresent(way -> way.add(point));
                }
            });
        }
    }

    /**
     * The fields of an event.
     *
     * @param said what the script says of some
     */
    Map<String, Value> fields(EventType type, Map<String, JsonNode> said) {
        Map<String, Value> given = new LinkedHashMap<>();
        for (FieldType field : type.fields()) {
            Optional.ofNullable(said.get(field.name()))
                    .flatMap(node -> ValueJson.read(node, field.type(), vocabulary.types())
                            .result())
                    .or(field::defaultValue)
                    .or(() -> of(field.type()))
                    .ifPresent(value -> given.put(field.name(), value));
        }
        return given;
    }

    /** A value of a type; empty where it would name a robot or a task and there is none. */
    Optional<Value> of(ValueType type) {
        return of(type, "");
    }

    private Optional<Value> of(ValueType type, String robot) {
        if (type instanceof ValueType.ListOf list) {
            return list(list, robot);
        } else if (type instanceof ValueType.MapOf map) {
            return map(map);
        } else if (type instanceof ValueType.Named named) {
            return Optional.ofNullable(vocabulary.types().get(named.name())).flatMap(this::named);
        }
        return simple((ValueType.Simple) type, robot);
    }

    private Optional<Value> list(ValueType.ListOf list, String robot) {
        if (list.element() == ValueType.Simple.POINT) {
            List<GeoPoint> points = robot.isEmpty() ? made(locations) : way(robot);
            return Optional.of(new ListValue(List.copyOf(points)));
        } else if (list.element() == ValueType.Simple.TEXT) {
            return Optional.of(new ListValue(List.of()));
        } else if (list.element() == ValueType.Simple.PROXY) {
            return Optional.of(new ListValue(
                    robots.stream().map(name -> (Value) new ProxyValue(name)).toList()));
        }
        return of(list.element(), robot).map(item -> new ListValue(List.of(item)));
    }

    private List<GeoPoint> made(int count) {
        return IntStream.range(0, count).mapToObj(this::point).toList();
    }

    private List<GeoPoint> way(String robot) {
        List<GeoPoint> way = ways.getOrDefault(robot, List.of());
        boolean isDivided = ways.values().stream().anyMatch(one -> !one.isEmpty());
        return isDivided ? way : List.of(point(Math.max(0, robots.indexOf(robot))));
    }

    private GeoPoint point(int number) {
        return GeoPoint.of(40 + salt * QUESTION_DEG, 10 + number * SPACING_DEG);
    }

    private Optional<Value> simple(ValueType.Simple type, String robot) {
        int small = 1 + salt % 7;
        return switch (type) {
            case BOOLEAN -> Optional.of(new BooleanValue(true));
            case INTEGER -> Optional.of(new IntegerValue(small));
            case REAL -> Optional.of(new RealValue(small));
            case TEXT, ANY -> Optional.of(new TextValue("text " + salt));
            case DURATION -> Optional.of(new DurationValue(1000L * small));
            case PROXY -> robots.stream().findFirst().map(ProxyValue::new);
            case TASK -> tasks.stream().findFirst().map(task -> task);
            case POINT ->
                Optional.of(
                        robot.isEmpty()
                                ? point(0)
                                : way(robot).stream().findFirst().orElse(point(robots.indexOf(robot))));
            case PATH -> Optional.of(new GeoPath(robot.isEmpty() ? made(2) : way(robot)));
            case AREA ->
                Optional.of(new GeoArea(
                        List.of(point(0), point(1), GeoPoint.of(point(1).latDeg() + SPACING_DEG, point(1).lonDeg())),
                        List.of()));
            case VARIABLE, PLAN -> Optional.empty();
        };
    }

    /** A map whose keys are robots or tasks has one entry for each. */
    private Optional<Value> map(ValueType.MapOf type) {
        Map<Value, Value> entries = new LinkedHashMap<>();
        if (type.key() == ValueType.Simple.PROXY) {
            robots.forEach(
                    robot -> of(type.value(), robot).ifPresent(value -> entries.put(new ProxyValue(robot), value)));
        } else if (type.key() == ValueType.Simple.TASK) {
            for (TaskId task : tasks) {
                String robot = robots.isEmpty() ? "" : robots.get(entries.size() % robots.size());
                Optional<Value> value = type.value() == ValueType.Simple.PROXY
                        ? Optional.of(robot).filter(name -> !name.isEmpty()).map(ProxyValue::new)
                        : of(type.value(), robot);
                value.ifPresent(found -> entries.put(task, found));
            }
        }
        return Optional.of(new MapValue(entries));
    }

    private Optional<Value> named(NamedType type) {
        if (type instanceof NamedType.Enumeration enumeration) {
            return enumeration.constants().stream().findFirst().map(first -> new EnumValue(enumeration.name(), first));
        }
        NamedType.RecordType record = (NamedType.RecordType) type;
        Map<String, Value> fields = new LinkedHashMap<>();
        record.fields().forEach((name, field) -> of(field).ifPresent(value -> fields.put(name, value)));
        return fields.size() == record.fields().size()
                ? Optional.of(new RecordValue(record.name(), fields))
                : Optional.empty();
    }
}
