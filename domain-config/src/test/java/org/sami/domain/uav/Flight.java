package org.sami.domain.uav;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import org.sami.spn.engine.EngineView;
import org.sami.spn.host.ActivationHandler;
import org.sami.spn.host.EngineHost;
import org.sami.spn.host.HandlerContext;
import org.sami.spn.host.HostListener;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.Occurrence;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.RealValue;
import org.sami.spn.value.TaskId;
import org.sami.spn.value.TextValue;
import org.sami.spn.value.Value;

/**
 * The domain's handlers: what plans ask of aircraft, done by simulated ones, and answered when it is done. An aircraft flies to its
 * tasks one after another, and to the next one when it has searched around the one before it. All on the test's thread.
 */
final class Flight implements HostListener {
    private static final double CEILING_M = 120;
    private static final double CIRCLING_MPS = 8;

    private final Map<String, SimulatedUav> fleet = new LinkedHashMap<>();
    private final Map<String, Order> orders = new LinkedHashMap<>(); // by aircraft
    private final Map<String, Deque<Order>> next = new LinkedHashMap<>(); // by aircraft
    private final Map<String, TaskId> busyWith = new LinkedHashMap<>(); // by aircraft
    private final List<GeoPoint> targets = new ArrayList<>();
    private EngineHost host;

    /** What an aircraft does, for whom, and how that answers. */
    private record Order(
            Activation activation,
            HandlerContext context,
            Optional<TaskId> task,
            Consumer<SimulatedUav> begin,
            Consumer<Order> answer) {}

    /** Puts the handlers on a host. */
    void install(EngineHost theHost) {
        host = theHost;
        Map<String, ActivationHandler> handlers = Map.of(
                "FlyTo",
                this::flyTo,
                "Land",
                this::land,
                "LookAround",
                this::lookAround,
                "SearchAround",
                this::searchAround,
                "ReturnHome",
                this::returnHome,
                "ComputeAllocations",
                new TaskDivision(fleet));
        handlers.forEach((type, handler) -> host.register(type, handler, Runnable::run));
        host.addListener(this);
    }

    void add(String name, SimulatedUav aircraft) {
        fleet.put(name, aircraft);
    }

    /** Puts something on the ground that a search finds. */
    void addTarget(GeoPoint where) {
        targets.add(where);
    }

    private void flyTo(Activation activation, HandlerContext context) {
        double speedMps = real(activation, "speed");
        for (TaskId task : activation.tasks()) {
            String name = activation.allocation().get(task);
            GeoPoint to = (GeoPoint) activation.taskValues().get(task).get("location");
            flyTo(name, to, speedMps, activation, context, Optional.of(task));
        }
        if (activation.tasks().isEmpty()) {
            GeoPoint to = (GeoPoint) activation.value("location").orElseThrow();
            activation.proxies().forEach(name -> flyTo(name, to, speedMps, activation, context, Optional.empty()));
        }
    }

    private void flyTo(
            String name,
            GeoPoint to,
            double speedMps,
            Activation activation,
            HandlerContext context,
            Optional<TaskId> task) {
        Order order = new Order(activation, context, task, uav -> uav.flyTo(to, speedMps), there -> {
            task.ifPresent(t -> busyWith.put(name, t));
            answer(there, "ReachedLocation", name, Map.of());
        });
        if (to.altM() > CEILING_M) {
            Value reason = new TextValue(to.altM() + " m is above the ceiling of " + CEILING_M + " m");
            answer(order, "CannotFly", name, Map.of("reason", reason));
        } else {
            next.computeIfAbsent(name, n -> new ArrayDeque<>()).add(order);
        }
    }

    private void searchAround(Activation activation, HandlerContext context) {
        double radiusM = real(activation, "radius");
        for (TaskId task : activation.tasks()) {
            String name = activation.allocation().get(task);
            now(
                    name,
                    new Order(
                            activation,
                            context,
                            Optional.of(task),
                            uav -> uav.circle(radiusM, CIRCLING_MPS),
                            searched -> {
                                busyWith.remove(name);
                                SimulatedUav uav = fleet.get(name);
                                Optional<GeoPoint> seen = targets.stream()
                                        .filter(target -> uav.distanceM(target) <= radiusM)
                                        .findFirst();
                                answer(
                                        searched,
                                        seen.isPresent() ? "TargetSeen" : "NothingSeen",
                                        name,
                                        seen.map(at -> Map.<String, Value>of("at", at))
                                                .orElse(Map.of()));
                            }));
        }
    }

    private void returnHome(Activation activation, HandlerContext context) {
        for (String name : activation.proxies()) {
            now(
                    name,
                    new Order(
                            activation,
                            context,
                            Optional.empty(),
                            uav -> uav.returnHome(CIRCLING_MPS),
                            down -> answer(down, "Landed", name, Map.of())));
        }
    }

    private void land(Activation activation, HandlerContext context) {
        for (String name : activation.proxies()) {
            now(
                    name,
                    new Order(
                            activation,
                            context,
                            Optional.empty(),
                            SimulatedUav::land,
                            down -> answer(down, "Landed", name, Map.of())));
        }
    }

    private void lookAround(Activation activation, HandlerContext context) {
        for (String name : activation.proxies()) {
            Map<String, Value> from = Map.of("from", fleet.get(name).position());
            answer(new Order(activation, context, Optional.empty(), uav -> {}, o -> {}), "PictureTaken", name, from);
        }
    }

    private static double real(Activation activation, String field) {
        return ((RealValue) activation.value(field).orElseThrow()).value();
    }

    private void now(String name, Order order) {
        orders.put(name, order);
        order.begin().accept(fleet.get(name));
    }

    /** Answers with the task where one was asked for, else with the aircraft. */
    private static void answer(Order order, String type, String name, Map<String, Value> values) {
        List<String> aircraft = order.task().isPresent() ? List.of() : List.of(name);
        List<TaskId> tasks = order.task().map(List::of).orElse(List.of());
        order.context().post(new Input.Received(Occurrence.answer(type, order.activation(), aircraft, tasks, values)));
    }

    /** Lets time pass for all aircraft. */
    void step(double seconds) {
        for (Map.Entry<String, SimulatedUav> each : fleet.entrySet()) {
            String name = each.getKey();
            Deque<Order> waiting = next.getOrDefault(name, new ArrayDeque<>());
            if (!orders.containsKey(name) && !busyWith.containsKey(name) && !waiting.isEmpty()) {
                now(name, waiting.remove());
            }
            each.getValue().step(seconds);
            if (orders.containsKey(name) && each.getValue().isThere()) {
                Order done = orders.remove(name);
                done.answer().accept(done);
            }
        }
    }

    /** What is withdrawn is done no longer: the aircraft stands in the air. Tasks that lose their aircraft are told. */
    @Override
    public void onStep(long index, long atMillis, Input input, List<Effect> effects, EngineView view) {
        for (Effect effect : effects) {
            if (effect instanceof Effect.CommandsWithdrawn withdrawn) {
                List<String> named = withdrawn.proxies().isEmpty() ? List.copyOf(fleet.keySet()) : withdrawn.proxies();
                named.forEach(name -> withdraw(name, withdrawn.mission()));
            } else if (effect instanceof Effect.TasksAllocated allocated) {
                allocated.robots().forEach((task, robot) -> {
                    if (robot.isEmpty() && allocated.before().containsKey(task)) {
                        host.post(new Input.Received(new Occurrence(
                                "AircraftLost", task.mission(), Ids.NONE, List.of(), List.of(task), Map.of())));
                    }
                });
            }
        }
    }

    private void withdraw(String name, long mission) {
        next.getOrDefault(name, new ArrayDeque<>())
                .removeIf(order -> order.activation().mission() == mission);
        Order order = orders.get(name);
        if (order != null && order.activation().mission() == mission) {
            orders.remove(name);
            fleet.get(name).hover();
        }
    }
}
