package org.sami.crw.mavlink;

import java.util.ArrayList;
import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.Executor;
import java.util.function.Consumer;
import org.sami.mavlink.base.MavlinkBase;
import org.sami.mavlink.mission.HeldKind;
import org.sami.mavlink.mission.MissionItem;
import org.sami.mavlink.vehicle.VehicleId;

/**
 * The session's fence and no-go areas as the vehicle's own fence, on which it acts without a base: compared with what the vehicle holds once the base commands
 * it, sent where it differs, and read back equal. Its parameters are set and read back with it. As long as the session has no areas, the vehicle's fence is its
 * owner's. For the gateway's thread.
 *
 * <p>Source: ArduPilot's parameters {@code FENCE_TYPE} (4: polygons alone; the circle is about its home), {@code FENCE_ACTION} (2: mode HOLD) and {@code
 * FENCE_ENABLE}.
 */
final class VehicleFence {
    private static final long AGAIN_MS = 30_000; // after a fault
    private static final String ENABLE = "FENCE_ENABLE";
    private static final Map<String, Integer> IN_FORCE = inForce();

    private final MavlinkBase base;
    private final VehicleId id;
    private final Executor thread;
    private final Consumer<String> alarm;
    private List<MissionItem> wanted = List.of();
    private Optional<List<MissionItem>> settled = Optional.empty(); // the vehicle was read to hold it, and to heed it
    private boolean isOurs; // what it holds was put there by this process
    private boolean busy;
    private long notBeforeMs;
    private String lastFault = "";

    private static Map<String, Integer> inForce() {
        Map<String, Integer> values = new LinkedHashMap<>(); // in the order in which they are set
        values.put("FENCE_TYPE", 4);
        values.put("FENCE_ACTION", 2);
        values.put(ENABLE, 1);
        return values;
    }

    /**
     * Nothing is known or wanted yet.
     *
     * @param alarm receives faults, in words for the operator
     */
    VehicleFence(MavlinkBase base, VehicleId id, Executor thread, Consumer<String> alarm) {
        this.base = base;
        this.id = id;
        this.thread = thread;
        this.alarm = alarm;
    }

    /** The fence that it is to hold from now on; empty for none of the session's. */
    void want(List<MissionItem> fence) {
        wanted = fence;
        notBeforeMs = 0;
    }

    /** Its autopilot has started again: what it holds is compared once more. */
    void restarted() {
        settled = Optional.empty();
    }

    /** Brings the vehicle to hold what is wanted, as long as the base commands it. To be called often. */
    void tick(long atMs, boolean isCommanded) {
        boolean nothingToDo = settled.isEmpty() && wanted.isEmpty() && !isOurs;
        if (isCommanded && !busy && !nothingToDo && atMs >= notBeforeMs && !settled.equals(Optional.of(wanted))) {
            busy = true;
            notBeforeMs = atMs + AGAIN_MS;
            if (wanted.isEmpty()) {
                remove();
            } else {
                Results.when(base.held(id, HeldKind.FENCE), thread, held -> compare(wanted, held), this::failed);
            }
        }
    }

    private void compare(List<MissionItem> fence, List<MissionItem> held) {
        if (FenceItems.isHeld(fence, held)) {
            heed(fence);
            return;
        }
        if (!held.isEmpty() && !isOurs) {
            alarm.accept("vehicle " + id + " held a fence of its own with " + held.size()
                    + " corners; the fence and no-go areas of this session take its place");
        }
        isOurs = true;
        Results.when(base.replace(id, HeldKind.FENCE, fence), thread, there -> heed(fence), this::failed);
    }

    /** Sets what of its parameters is another, in their order. */
    private void heed(List<MissionItem> fence) {
        set(new ArrayList<>(IN_FORCE.entrySet()).iterator(), () -> {
            isOurs = true;
            done(fence);
        });
    }

    private void set(Iterator<Map.Entry<String, Integer>> values, Runnable then) {
        if (!values.hasNext()) {
            then.run();
            return;
        }
        Map.Entry<String, Integer> value = values.next();
        Results.when(
                base.parameter(id, value.getKey()),
                thread,
                now -> {
                    if (Math.round(now) == value.getValue()) {
                        set(values, then);
                    } else {
                        Results.when(
                                base.setParameter(id, value.getKey(), value.getValue()),
                                thread,
                                set -> set(values, then),
                                this::failed);
                    }
                },
                this::failed);
    }

    /** Takes away what this process has put there: first it is no longer heeded. */
    private void remove() {
        set(
                List.of(Map.entry(ENABLE, 0)).iterator(),
                () -> Results.when(
                        base.replace(id, HeldKind.FENCE, List.of()),
                        thread,
                        nothing -> {
                            isOurs = false;
                            done(List.of());
                        },
                        this::failed));
    }

    private void done(List<MissionItem> fence) {
        busy = false;
        notBeforeMs = 0;
        lastFault = "";
        settled = Optional.of(fence);
    }

    private void failed(String why) {
        busy = false;
        if (!why.equals(lastFault)) {
            lastFault = why;
            alarm.accept("vehicle " + id + " does not keep to the fence of this session by itself: " + why);
        }
    }
}
