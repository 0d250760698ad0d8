package org.sami.uav.handler;

import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.sami.crw.service.Geodesy;
import org.sami.spn.host.ActivationHandler;
import org.sami.spn.host.HandlerContext;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.Occurrence;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.ListValue;
import org.sami.spn.value.MapValue;
import org.sami.spn.value.ProxyValue;
import org.sami.spn.value.RealValue;
import org.sami.spn.value.RecordValue;
import org.sami.spn.value.TaskId;
import org.sami.spn.value.TextValue;
import org.sami.spn.value.Value;

/** Compute Allocations: divides the tasks so that the longest way is short, or gives each to the nearest aircraft. The one with the shorter longest way is first. */
final class TaskDivision implements ActivationHandler {
    private final Flights flights;

    TaskDivision(Flights flights) {
        this.flights = flights;
    }

    /** Where an aircraft is after its tasks, and how far it flies to do them. */
    private record Way(GeoPoint end, double metres) {
        Way to(GeoPoint location) {
            return new Way(location, metres + Geodesy.distanceM(end, location));
        }
    }

    /** The tasks of each aircraft in order, and the ways on which it gets there. */
    private static final class Shares {
        final Map<String, Way> ways = new LinkedHashMap<>();
        final Map<Value, Value> tasks = new LinkedHashMap<>();

        final String method;

        Shares(Map<String, GeoPoint> from, String method) {
            this.method = method;
            from.forEach((aircraft, at) -> ways.put(aircraft, new Way(at, 0)));
        }

        void give(TaskId task, GeoPoint location, String aircraft) {
            ways.computeIfPresent(aircraft, (name, way) -> way.to(location));
            tasks.put(task, new ProxyValue(aircraft));
        }

        double longestM() {
            return ways.values().stream().mapToDouble(Way::metres).max().orElse(0);
        }

        Value toValue() {
            Map<String, Value> fields = new LinkedHashMap<>(); // as declared: the journal has them in this order
            fields.put("tasks", new MapValue(tasks));
            fields.put("longestM", new RealValue(longestM()));
            fields.put("method", new TextValue(method));
            return new RecordValue("Allocation", fields);
        }
    }

    @Override
    public void handle(Activation activation, HandlerContext context) {
        Map<String, GeoPoint> from = new LinkedHashMap<>();
        context.query(view -> view.proxies())
                .forEach(name -> flights.position(name).ifPresent(at -> from.put(name, at)));
        if (from.isEmpty()) {
            throw new IllegalArgumentException("no aircraft has said where it is");
        }
        Map<TaskId, GeoPoint> locations = new LinkedHashMap<>();
        activation.tasks().forEach(task -> locations.put(task, location(context, task)));
        Shares even = new Shares(from, "short ways for all");
        Shares nearest = new Shares(from, "the nearest");
        while (even.tasks.size() < locations.size()) {
            giveShortest(even, locations);
        }
        locations.forEach((task, location) -> nearest.give(
                task,
                location,
                from.entrySet().stream()
                        .min(Comparator.comparingDouble(each -> Geodesy.distanceM(each.getValue(), location)))
                        .orElseThrow()
                        .getKey()));
        List<Value> options = Stream.of(even, nearest)
                .sorted(Comparator.comparingDouble(Shares::longestM))
                .map(Shares::toValue)
                .toList();
        context.post(new Input.Received(Occurrence.answer(
                UavEvents.ALLOCATIONS_COMPUTED,
                activation,
                List.of(),
                activation.tasks(),
                Map.of("allocations", new ListValue(options)))));
    }

    private record Choice(TaskId task, GeoPoint location, String aircraft, double metres) {}

    /** Gives the task that makes some aircraft's way the least long. */
    private static void giveShortest(Shares shares, Map<TaskId, GeoPoint> locations) {
        locations.entrySet().stream()
                .filter(each -> !shares.tasks.containsKey(each.getKey()))
                .flatMap(each -> shares.ways.entrySet().stream()
                        .map(way -> new Choice(
                                each.getKey(),
                                each.getValue(),
                                way.getKey(),
                                way.getValue().to(each.getValue()).metres())))
                .min(Comparator.comparingDouble(Choice::metres))
                .ifPresent(best -> shares.give(best.task(), best.location(), best.aircraft()));
    }

    private static GeoPoint location(HandlerContext context, TaskId task) {
        return context.query(view -> view.task(task))
                .map(values -> values.get("location"))
                .filter(GeoPoint.class::isInstance)
                .map(GeoPoint.class::cast)
                .orElseThrow(() -> new IllegalArgumentException("the task " + task.name() + " has no location"));
    }
}
