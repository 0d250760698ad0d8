package org.sami.uav.handler;

import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.Executor;
import java.util.function.Consumer;
import java.util.stream.Stream;
import org.sami.crw.fleet.FleetEvent;
import org.sami.crw.message.MessageSink;
import org.sami.crw.message.OperatorMessage;
import org.sami.crw.service.Geodesy;
import org.sami.spn.engine.EngineView;
import org.sami.spn.host.ActivationHandler;
import org.sami.spn.host.HandlerContext;
import org.sami.spn.host.HostListener;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.Occurrence;
import org.sami.spn.protocol.Priority;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.ListValue;
import org.sami.spn.value.MapValue;
import org.sami.spn.value.ProxyValue;
import org.sami.spn.value.RealValue;
import org.sami.spn.value.RecordValue;
import org.sami.spn.value.TaskId;
import org.sami.spn.value.TextValue;
import org.sami.spn.value.Value;

/**
 * Compute Allocations: divides the tasks so that the longest way is short, or gives each to the nearest aircraft. The one with the shorter longest way is first.
 * Aircraft whose batteries are low get none; where all are low, the tasks wait until one is charged, and so does one at which the others have failed too often. A task at which all aircraft have failed too often ({@link TaskFailures})
 * waits for another battery, unless the plan leaves it out ({@link ImpossibleTasks}). The operator is told of each that waits. For the fleet's thread; it passes the engine's steps on to it.
 */
final class TaskDivision implements ActivationHandler, Consumer<FleetEvent>, HostListener {
    private final Flights flights;
    private final MessageSink messages;
    private final Executor fleet;
    private final TaskFailures failures;
    private final Map<Long, Waiting> waiting = new LinkedHashMap<>(); // by activation
    private final WaitingTasks told;

    TaskDivision(Flights flights, MessageSink messages, Executor fleet, TaskFailures failures) {
        this.failures = failures;
        this.flights = flights;
        this.messages = messages;
        this.fleet = fleet;
        told = new WaitingTasks(messages, failures);
    }

    /** Tasks for which no aircraft is charged, or that none can do. */
    private record Waiting(Activation activation, HandlerContext context, List<TaskId> tasks) {}

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
        Map<String, GeoPoint> all = placed(context);
        boolean isEarly = context.redelivered(); // nobody has said anything to this base yet
        if (all.isEmpty() && !isEarly) {
            throw new IllegalArgumentException("no aircraft has said where it is");
        }
        if (!all.isEmpty() && charged(all, context).isEmpty() && !isEarly) {
            tellThatAllAreLow(activation, context);
        }
        Waiting tasks = new Waiting(activation, context, activation.tasks());
        divide(tasks, charged(all, context));
    }

    private Map<String, GeoPoint> charged(Map<String, GeoPoint> placed, HandlerContext context) {
        Map<String, GeoPoint> from = new LinkedHashMap<>(placed);
        from.keySet().removeIf(name -> !flights.isCharged(name, context));
        return from;
    }

    /** Once for a mission, however many tasks it allocates. */
    private void tellThatAllAreLow(Activation activation, HandlerContext context) {
        messages.tell(new OperatorMessage(
                context.nowMillis(),
                activation.mission(),
                OperatorMessage.Source.DOMAIN,
                Priority.HIGH,
                "All batteries are low: the tasks are allocated once one is charged",
                List.of(),
                "low-batteries/" + activation.mission()));
    }

    private Map<String, GeoPoint> placed(HandlerContext context) {
        Map<String, GeoPoint> from = new LinkedHashMap<>();
        context.query(view -> view.proxies())
                .forEach(name -> flights.position(name).ifPresent(at -> from.put(name, at)));
        return from;
    }

    @Override
    public void accept(FleetEvent event) {
        if (event instanceof FleetEvent.StatusReported) {
            for (Waiting one : List.copyOf(waiting.values())) {
                divide(one, charged(placed(one.context), one.context));
            }
        }
    }

    @Override
    public void onStep(long index, long atMillis, Input input, List<Effect> effects, EngineView view) {
        for (Effect effect : effects) {
            if (effect instanceof Effect.ActivationEnded ended) {
                fleet.execute(() -> waiting.remove(ended.activation()));
            } else if (effect instanceof Effect.MissionEnded ended) {
                fleet.execute(() -> told.forget(ended.mission()));
            }
        }
    }

    /** Those for which an aircraft is charged; the others wait. */
    private void divide(Waiting tasks, Map<String, GeoPoint> from) {
        Map<TaskId, List<String>> candidates = new LinkedHashMap<>();
        for (TaskId task : tasks.tasks) {
            List<String> able = failures.candidates(task, List.copyOf(from.keySet()));
            if (!able.isEmpty()) {
                candidates.put(task, able);
            }
        }
        List<TaskId> later = tasks.tasks.stream()
                .filter(task -> !candidates.containsKey(task))
                .toList();
        boolean isNothingToDo = tasks.tasks.isEmpty() && !from.isEmpty(); // then the plan still waits for the answer
        boolean isAnswered = isNothingToDo || !candidates.isEmpty();
        waiting.remove(tasks.activation.id());
        told.allocated(candidates.keySet());
        if (!from.isEmpty()) { // else all are low
            tellOfWaiting(tasks, later, from.keySet());
        }
        if (!later.isEmpty() || !isAnswered) {
            waiting.put(tasks.activation.id(), new Waiting(tasks.activation, tasks.context, later));
        }
        if (isAnswered) {
            divide(tasks.activation, tasks.context, from, candidates);
        }
    }

    private void tellOfWaiting(Waiting tasks, List<TaskId> later, Set<String> charged) {
        for (TaskId task : later) {
            placeOf(tasks.context, task)
                    .ifPresent(place -> told.hold(
                            tasks.activation,
                            tasks.context,
                            task,
                            place,
                            placed(tasks.context).keySet(),
                            charged));
        }
    }

    private static void divide(
            Activation activation,
            HandlerContext context,
            Map<String, GeoPoint> from,
            Map<TaskId, List<String>> candidates) {
        Map<TaskId, GeoPoint> locations = new LinkedHashMap<>();
        candidates.keySet().forEach(task -> locations.put(task, location(context, task)));
        Shares even = new Shares(from, "short ways for all");
        Shares nearest = new Shares(from, "the nearest");
        while (even.tasks.size() < locations.size()) {
            giveShortest(even, locations, candidates);
        }
        candidates.forEach((task, able) -> {
            GeoPoint location = location(context, task);
            from.entrySet().stream()
                    .filter(each -> able.contains(each.getKey()))
                    .min(Comparator.comparingDouble(each -> Geodesy.distanceM(each.getValue(), location)))
                    .ifPresent(each -> nearest.give(task, location, each.getKey()));
        });
        List<Value> options = Stream.of(even, nearest)
                .sorted(Comparator.comparingDouble(Shares::longestM))
                .map(Shares::toValue)
                .toList();
        context.post(new Input.Received(Occurrence.answer(
                UavEvents.ALLOCATIONS_COMPUTED,
                activation,
                List.of(),
                List.copyOf(candidates.keySet()),
                Map.of("allocations", new ListValue(options)))));
    }

    private record Choice(TaskId task, GeoPoint location, String aircraft, double metres) {}

    /** Gives the task that makes some aircraft's way the least long. */
    private static void giveShortest(
            Shares shares, Map<TaskId, GeoPoint> locations, Map<TaskId, List<String>> candidates) {
        locations.entrySet().stream()
                .filter(each -> !shares.tasks.containsKey(each.getKey()))
                .flatMap(each -> shares.ways.entrySet().stream()
                        .filter(way -> candidates
                                .getOrDefault(each.getKey(), List.of())
                                .contains(way.getKey()))
                        .map(way -> new Choice(
                                each.getKey(),
                                each.getValue(),
                                way.getKey(),
                                way.getValue().to(each.getValue()).metres())))
                .min(Comparator.comparingDouble(Choice::metres))
                .ifPresent(best -> shares.give(best.task(), best.location(), best.aircraft()));
    }

    private static GeoPoint location(HandlerContext context, TaskId task) {
        return placeOf(context, task)
                .orElseThrow(() -> new IllegalArgumentException("the task " + task.name() + " has no location"));
    }

    private static Optional<GeoPoint> placeOf(HandlerContext context, TaskId task) {
        return context.query(view -> view.task(task))
                .map(values -> values.get("location"))
                .filter(GeoPoint.class::isInstance)
                .map(GeoPoint.class::cast);
    }
}
