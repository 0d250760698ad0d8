package org.sami.uav.handler;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HashMap;
import java.util.Iterator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.Executor;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import org.sami.crw.fleet.FleetEvent;
import org.sami.crw.handler.motion.LaterMoves;
import org.sami.crw.handler.motion.MotionCommands;
import org.sami.crw.handler.motion.Move;
import org.sami.crw.handler.motion.Reply;
import org.sami.crw.proxy.BoatProxy;
import org.sami.crw.proxy.ProxyRegistry;
import org.sami.crw.proxy.status.BoatStatus;
import org.sami.spn.engine.EngineView;
import org.sami.spn.host.HandlerContext;
import org.sami.spn.host.HostListener;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Input;
import org.sami.spn.value.TaskId;

/**
 * Flights to the locations of tasks. An aircraft with several flies to the next one when it has no flight and no search of a task any longer, and its battery is not low; what becomes
 * of its tasks where that is low and it is on the ground, {@link LowBatteryTasks} decides. For the fleet's thread; it passes the engine's steps on to it.
 */
final class TaskFlights implements Consumer<FleetEvent>, HostListener, LaterMoves {
    private static final Reply REPLY = Reply.way(UavEvents.REACHED_LOCATION, UavEvents.CANNOT_FLY);

    private final ProxyRegistry robots;
    private final Flights flights;
    private final MotionCommands motion;
    private final Executor fleet;
    private final LowBatteryTasks lowBattery;
    private final Set<String> keeping;
    private final Map<String, Deque<Waiting>> waiting = new HashMap<>(); // by aircraft
    private final Map<String, Flown> flown = new HashMap<>(); // by aircraft: its last flight
    private final Map<String, TaskId> arrived = new HashMap<>(); // by aircraft: the task whose answer is under way

    private record Waiting(Activation activation, HandlerContext context, Flights.Flight flight) {
        TaskId task() {
            return flight.aircraft().tasks().get(0);
        }

        Move move() {
            return Flights.move(activation, context, flight, REPLY, "-" + task().name());
        }

        boolean isOpen() {
            return flight.aircraft().stands(activation, context) && !move().isOver(activation, context);
        }
    }

    /** A flight under way, or over. */
    private record Flown(TaskId task, String commandId) {}

    /**
     * No flights yet.
     *
     * @param keeping types of output events that keep an aircraft at its task
     */
    TaskFlights(
            ProxyRegistry robots,
            Flights flights,
            MotionCommands motion,
            Executor fleet,
            LowBatteryTasks lowBattery,
            Set<String> keeping) {
        this.robots = robots;
        this.flights = flights;
        this.motion = motion;
        this.fleet = fleet;
        this.lowBattery = lowBattery;
        this.keeping = Set.copyOf(keeping);
    }

    /** A flight of one task, after those that wait. */
    void add(Activation activation, HandlerContext context, Flights.Flight flight) {
        waiting.computeIfAbsent(flight.aircraft().boat(), name -> new ArrayDeque<>())
                .add(new Waiting(activation, context, flight));
    }

    /** Has every aircraft begin its next flight that can. */
    void startWaiting() {
        List.copyOf(waiting.keySet()).forEach(this::start);
    }

    private void start(String aircraft) {
        Deque<Waiting> queue = waiting.getOrDefault(aircraft, new ArrayDeque<>());
        while (!queue.isEmpty()) {
            Waiting next = queue.peek();
            if (isBusy(aircraft, next)) {
                return;
            } else if (!flights.isCharged(aircraft, next.context)) {
                boolean inTheAir = flights.isAirborne(aircraft); // or just down: it has not said so yet
                giveBack(aircraft, inTheAir, queue);
                if (!inTheAir || queue.isEmpty()) {
                    return;
                }
                next = queue.peek();
            }
            lowBattery.flies(aircraft);
            queue.remove();
            Optional<String> reason = flights.refusal(next.flight);
            if (reason.isPresent()) {
                motion.refuse(next.activation, next.context, next.flight.aircraft(), REPLY, reason.get());
            } else if (next.flight.aircraft().stands(next.activation, next.context)) {
                Move move = next.move();
                if (!move.isOver(next.activation, next.context)) {
                    flown.put(aircraft, new Flown(next.task(), move.command().commandId()));
                    motion.send(next.activation, next.context, List.of(move));
                    return;
                }
            }
        }
        waiting.remove(aircraft);
    }

    private boolean isBusy(String aircraft, Waiting next) {
        Optional<BoatProxy> proxy = robots.find(aircraft);
        boolean flies = proxy.isPresent()
                && proxy.get().commands().current().stream()
                        .anyMatch(command -> command.mission() == next.activation.mission());
        return flies
                || motion.comesHome(aircraft)
                || motion.held(aircraft).contains(next.activation.mission())
                || arrived.containsKey(aircraft)
                || next.context.query(view -> isKept(aircraft, next.activation.mission(), view));
    }

    /** Once it has said to this base where it is, and how its battery is. */
    private void giveBack(String aircraft, boolean inTheAir, Deque<Waiting> queue) {
        robots.find(aircraft)
                .map(BoatProxy::status)
                .filter(status -> status.pose().isPresent())
                .flatMap(BoatStatus::battery)
                .ifPresent(battery -> {
                    List<LowBatteryTasks.Task> tasks = queue.stream()
                            .filter(Waiting::isOpen)
                            .map(one -> new LowBatteryTasks.Task(one.activation, one.context, one.task()))
                            .toList();
                    Set<TaskId> back = lowBattery.giveBack(aircraft, inTheAir, battery, tasks);
                    queue.removeIf(one -> back.contains(one.task()));
                    if (queue.isEmpty()) {
                        waiting.remove(aircraft);
                    }
                });
    }

    private boolean isKept(String aircraft, long mission, EngineView view) {
        return view.openActivations().stream()
                .filter(open -> open.mission() == mission && keeping.contains(open.type()))
                .flatMap(open -> open.tasks().stream())
                .anyMatch(task -> aircraft.equals(view.allocation().get(task)));
    }

    @Override
    public void accept(FleetEvent event) {
        if (event instanceof FleetEvent.StatusReported reported) {
            start(reported.status().boatId()); // where it waited for a charged battery
        }
        if (event instanceof FleetEvent.CommandCompleted done && waiting.containsKey(done.boat())) {
            Optional.ofNullable(flown.get(done.boat()))
                    .filter(flight -> flight.commandId().equals(done.command().commandId())) // others answer no task
                    .ifPresent(flight -> arrived.put(done.boat(), flight.task()));
        }
    }

    @Override
    public void onStep(long index, long atMillis, Input input, List<Effect> effects, EngineView view) {
        for (Effect effect : effects) {
            if (effect instanceof Effect.CommandsWithdrawn withdrawn) {
                fleet.execute(() -> withdraw(withdrawn.mission(), withdrawn.proxies()));
            } else if (effect instanceof Effect.TasksAllocated allocated) {
                fleet.execute(() -> allocated.before().forEach(this::drop));
            }
        }
        if (input instanceof Input.Received || !effects.isEmpty()) {
            fleet.execute(() -> stepped(input));
        }
    }

    /** A task that an aircraft had: it is another's, or comes again with the aircraft's next flights. */
    private void drop(TaskId task, String aircraft) {
        waiting.getOrDefault(aircraft, new ArrayDeque<>())
                .removeIf(one -> one.task().equals(task));
    }

    private void stepped(Input input) {
        if (waiting.isEmpty()) {
            arrived.clear();
            return;
        }
        if (input instanceof Input.Received received) {
            arrived.values().removeIf(received.occurrence().tasks()::contains);
        }
        startWaiting();
    }

    @Override
    public Set<Long> missions(String robot) {
        return waiting.getOrDefault(robot, new ArrayDeque<>()).stream()
                .map(one -> one.activation.mission())
                .collect(Collectors.toSet());
    }

    @Override
    public void withdraw(long mission, List<String> named, Optional<String> why, MotionCommands through) {
        withdraw(mission, named).forEach(one -> through.takeBack(one.activation, one.context, one.move(), why));
    }

    private List<Waiting> withdraw(long mission, List<String> named) {
        List<Waiting> taken = new ArrayList<>();
        for (Iterator<Map.Entry<String, Deque<Waiting>>> all =
                        waiting.entrySet().iterator();
                all.hasNext(); ) {
            Map.Entry<String, Deque<Waiting>> one = all.next();
            if (named.isEmpty() || named.contains(one.getKey())) {
                List<Waiting> ofMission = one.getValue().stream()
                        .filter(each -> each.activation.mission() == mission)
                        .toList();
                one.getValue().removeAll(ofMission);
                taken.addAll(ofMission);
                arrived.remove(one.getKey());
            }
            if (one.getValue().isEmpty()) {
                all.remove();
            }
        }
        return taken;
    }
}
