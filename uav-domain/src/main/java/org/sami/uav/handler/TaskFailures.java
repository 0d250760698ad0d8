package org.sami.uav.handler;

import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.concurrent.Executor;
import java.util.function.Consumer;
import org.sami.boat.link.BatteryDefaults;
import org.sami.crw.fleet.FleetEvent;
import org.sami.crw.handler.motion.MotionCommands;
import org.sami.crw.proxy.status.BatteryState;
import org.sami.spn.engine.EngineView;
import org.sami.spn.host.HostListener;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.Occurrence;
import org.sami.spn.value.TaskId;
import org.sami.spn.value.TextValue;

/**
 * How often aircraft failed at tasks that they had, other commands that took them not counted: a task is given to one that failed less often, and to none that failed {@link #MOST} times. Another battery
 * begins anew; a restart of the base does not. For the fleet's thread; it passes the engine's steps on to it.
 */
final class TaskFailures implements Consumer<FleetEvent>, HostListener {
    /** So often an aircraft is sent to one task: what was in its way may be gone the second time. */
    static final int MOST = 2;

    private final Executor fleet;
    private final Impossible impossible;
    private final Memory memory;
    private final Map<TaskId, Map<String, Failed>> failures = new HashMap<>(); // by task and aircraft
    private final Map<String, Double> charges =
            new HashMap<>(); // by aircraft, in percent; at its latest failure until it has reported one
    private final Set<String> heard = new HashSet<>(); // aircraft that have

    /**
     * Those that the missions remember.
     *
     * @param impossible learns of each task that no aircraft is to try any longer
     * @param memory keeps the failures over a restart of the base
     */
    TaskFailures(Executor fleet, Impossible impossible, Memory memory) {
        this.memory = memory;
        this.fleet = fleet;
        this.impossible = impossible;
    }

    /** What becomes of tasks that no aircraft is to try any longer. */
    interface Impossible {
        /** The aircraft that there are. */
        List<String> aircraft();

        /** All of them have failed. */
        void became(TaskId task);
    }

    /**
     * How often an aircraft failed at a task.
     *
     * @param times 1 or more
     * @param percent its charge when it failed last, as far as it had said
     */
    record Failed(int times, OptionalDouble percent) {}

    /** Where failures are kept over a restart of the base. */
    interface Memory {
        /** Those at a task, by aircraft. */
        Map<String, Failed> of(TaskId task);

        /** These are all at a task, by aircraft. */
        void keep(TaskId task, Map<String, Failed> failures);
    }

    /** Those of some aircraft that may try a task: that failed at it least often, and not too often; none where all have. */
    List<String> candidates(TaskId task, List<String> aircraft) {
        int least = aircraft.stream().mapToInt(one -> failures(task, one)).min().orElse(MOST);
        return least >= MOST
                ? List.of()
                : aircraft.stream().filter(one -> failures(task, one) == least).toList();
    }

    /** Whether an aircraft is not to try a task any longer. */
    boolean isOut(TaskId task, String aircraft) {
        return failures(task, aircraft) >= MOST;
    }

    private int failures(TaskId task, String aircraft) {
        return Optional.ofNullable(at(task).get(aircraft)).map(Failed::times).orElse(0);
    }

    /** Without those whose aircraft has had another battery since. */
    private Map<String, Failed> at(TaskId task) {
        return failures.computeIfAbsent(task, unused -> {
            Map<String, Failed> found = new HashMap<>(memory.of(task));
            found.forEach((aircraft, failed) -> failed.percent().ifPresent(percent -> {
                if (!heard.contains(aircraft)) { // its latest failure: an earlier one would make this another battery
                    charges.merge(aircraft, percent, Math::min);
                }
            }));
            found.entrySet()
                    .removeIf(one -> one.getValue().percent().isPresent()
                            && isRecharged(
                                    one.getValue().percent().getAsDouble(),
                                    Objects.requireNonNull(charges.get(one.getKey()))));
            return found;
        });
    }

    private static boolean isRecharged(double before, double percent) {
        return percent >= before + BatteryDefaults.RECHARGED_PERCENT;
    }

    @Override
    public void accept(FleetEvent event) {
        if (event instanceof FleetEvent.StatusReported reported) {
            String aircraft = reported.status().boatId();
            reported.status().battery().map(BatteryState::percent).ifPresent(percent -> {
                heard.add(aircraft);
                Double before = charges.put(aircraft, percent);
                if (before != null && isRecharged(before, percent)) {
                    beginAnew(aircraft);
                }
            });
        }
    }

    private void beginAnew(String aircraft) {
        failures.forEach((task, byAircraft) -> {
            if (byAircraft.remove(aircraft) != null) {
                memory.keep(task, byAircraft);
            }
        });
    }

    @Override
    public void onStep(long index, long atMillis, Input input, List<Effect> effects, EngineView view) {
        if (input instanceof Input.Received received
                && received.occurrence().type().equals(UavEvents.CANNOT_FLY)
                && !isDisplaced(received.occurrence())) {
            for (TaskId task : received.occurrence().tasks()) {
                Optional.ofNullable(view.allocation().get(task))
                        .ifPresent(aircraft -> fleet.execute(() -> failed(task, aircraft)));
            }
        }
        for (Effect effect : effects) {
            if (effect instanceof Effect.MissionEnded ended) {
                fleet.execute(() -> failures.keySet().removeIf(task -> task.mission() == ended.mission()));
            }
        }
    }

    /** Whether another command took the aircraft, which might have done the task. */
    private static boolean isDisplaced(Occurrence failure) {
        return failure.values().get("reason") instanceof TextValue reason && MotionCommands.isDisplaced(reason.value());
    }

    private void failed(TaskId task, String aircraft) {
        Double charge = charges.get(aircraft);
        OptionalDouble percent = charge == null ? OptionalDouble.empty() : OptionalDouble.of(charge);
        at(task).put(aircraft, new Failed(failures(task, aircraft) + 1, percent));
        memory.keep(task, at(task));
        List<String> all = impossible.aircraft();
        if (!all.isEmpty() && candidates(task, all).isEmpty()) {
            impossible.became(task);
        }
    }
}
