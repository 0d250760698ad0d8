package org.sami.uav.handler;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
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
 * begins anew, and so does a restart of the base. For the fleet's thread; it passes the engine's steps on to it.
 */
final class TaskFailures implements Consumer<FleetEvent>, HostListener {
    /** So often an aircraft is sent to one task: what was in its way may be gone the second time. */
    static final int MOST = 2;

    private final Executor fleet;
    private final Impossible impossible;
    private final Map<TaskId, Map<String, Integer>> failures = new HashMap<>(); // by task and aircraft
    private final Map<String, Double> charges = new HashMap<>(); // by aircraft, in percent

    /**
     * No failures yet.
     *
     * @param impossible learns of each task that no aircraft is to try any longer
     */
    TaskFailures(Executor fleet, Impossible impossible) {
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
        return failures.getOrDefault(task, Map.of()).getOrDefault(aircraft, 0);
    }

    @Override
    public void accept(FleetEvent event) {
        if (event instanceof FleetEvent.StatusReported reported) {
            String aircraft = reported.status().boatId();
            reported.status().battery().map(BatteryState::percent).ifPresent(percent -> {
                Double before = charges.put(aircraft, percent);
                if (before != null && percent >= before + BatteryDefaults.RECHARGED_PERCENT) {
                    failures.values().forEach(byAircraft -> byAircraft.remove(aircraft));
                }
            });
        }
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
        failures.computeIfAbsent(task, unused -> new HashMap<>()).merge(aircraft, 1, Integer::sum);
        List<String> all = impossible.aircraft();
        if (!all.isEmpty() && candidates(task, all).isEmpty()) {
            impossible.became(task);
        }
    }
}
