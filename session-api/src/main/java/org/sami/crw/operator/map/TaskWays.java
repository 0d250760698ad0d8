package org.sami.crw.operator.map;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.sami.spn.engine.EngineView;
import org.sami.spn.value.GeoPath;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.ListValue;
import org.sami.spn.value.MapValue;
import org.sami.spn.value.ProxyValue;
import org.sami.spn.value.RecordValue;
import org.sami.spn.value.TaskId;
import org.sami.spn.value.Value;

/** An allocation of tasks to robots as ways on a map: each robot goes to the places of its tasks, in the order of the allocation. */
public final class TaskWays {
    private TaskWays() {}

    /** The tasks that a value allocates to robots, at any depth. */
    public static Set<TaskId> tasks(Value value) {
        Set<TaskId> tasks = new LinkedHashSet<>();
        collect(value, tasks);
        return tasks;
    }

    private static void collect(Value value, Set<TaskId> into) {
        if (value instanceof MapValue map) {
            map.entries().forEach((key, one) -> {
                if (key instanceof TaskId task && one instanceof ProxyValue) {
                    into.add(task);
                } else {
                    collect(one, into);
                }
            });
        } else if (value instanceof RecordValue fields) {
            fields.fields().values().forEach(one -> collect(one, into));
        } else if (value instanceof ListValue list) {
            list.items().forEach(one -> collect(one, into));
        }
    }

    /** Where tasks are, as far as a field of theirs is a place; of several the first. */
    public static Map<TaskId, GeoPoint> places(Set<TaskId> tasks, EngineView view) {
        Map<TaskId, GeoPoint> places = new LinkedHashMap<>();
        for (TaskId task : tasks) {
            view.task(task).stream()
                    .flatMap(fields -> fields.values().stream())
                    .filter(GeoPoint.class::isInstance)
                    .map(GeoPoint.class::cast)
                    .findFirst()
                    .ifPresent(place -> places.put(task, place));
        }
        return places;
    }

    /** The same value with the path of each robot in place of its tasks, as far as their places are known. */
    public static Value of(Value value, Map<TaskId, GeoPoint> places) {
        if (value instanceof MapValue map) {
            Map<String, List<GeoPoint>> paths = new LinkedHashMap<>();
            map.entries().forEach((key, one) -> {
                if (key instanceof TaskId task && one instanceof ProxyValue robot && places.containsKey(task)) {
                    paths.computeIfAbsent(robot.proxy(), name -> new ArrayList<>())
                            .add(places.get(task));
                }
            });
            return paths.isEmpty() ? value : paths(paths);
        }
        if (value instanceof RecordValue fields) {
            Map<String, Value> ways = new LinkedHashMap<>();
            fields.fields().forEach((name, one) -> ways.put(name, of(one, places)));
            return new RecordValue(fields.type(), ways);
        }
        return value instanceof ListValue list
                ? new ListValue(
                        list.items().stream().map(one -> of(one, places)).toList())
                : value;
    }

    private static Value paths(Map<String, List<GeoPoint>> paths) {
        Map<Value, Value> byRobot = new LinkedHashMap<>();
        paths.forEach((robot, points) -> byRobot.put(new ProxyValue(robot), new GeoPath(points)));
        return new MapValue(byRobot);
    }
}
