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
 * owner's; one that an earlier session on this machine has left there is taken away. For the gateway's thread.
 *
 * <p>Source: ArduPilot's parameters {@code FENCE_TYPE} (4: polygons alone; the circle is about its home), {@code FENCE_ACTION} (2: mode HOLD) and {@code
 * FENCE_ENABLE}.
 */
final class VehicleFence {
    private static final long AGAIN_MS = 30_000; // after a fault
    private static final long AREAS_COME_MS = 10_000; // a session may load its project after it commands the vehicle
    private static final String ENABLE = "FENCE_ENABLE";
    private static final Map<String, Integer> IN_FORCE = inForce();

    private final MavlinkBase base;
    private final VehicleId id;
    private final Executor thread;
    private final Consumer<String> alarm;
    private final Consumer<List<String>> keep;
    private List<String> given; // the fences that this machine gave to it, of which it may hold one
    private List<MissionItem> wanted = List.of();
    private Optional<List<MissionItem>> settled = Optional.empty(); // the vehicle was read to hold it, and to heed it
    private boolean hadAreas; // the session has given up areas
    private Optional<Long> commandedMs = Optional.empty(); // since when
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
     * Nothing is known or asked for yet.
     *
     * @param alarm receives faults, in words for the operator
     * @param given the fences that earlier sessions on this machine gave to the vehicle and did not take away
     * @param keep receives these fences when they change, for later sessions
     */
    VehicleFence(
            MavlinkBase base,
            VehicleId id,
            Executor thread,
            Consumer<String> alarm,
            List<String> given,
            Consumer<List<String>> keep) {
        this.base = base;
        this.id = id;
        this.thread = thread;
        this.alarm = alarm;
        this.given = given;
        this.keep = keep;
    }

    /** The fence that it is to hold from now on; empty for none of the session's. */
    void want(List<MissionItem> fence) {
        hadAreas |= !wanted.isEmpty();
        wanted = fence;
        notBeforeMs = 0;
    }

    /** Its autopilot has started again: what it holds is compared once more. */
    void restarted() {
        settled = Optional.empty();
    }

    /** Brings the vehicle to hold the fence that is asked for, as long as the base commands it. To be called often. */
    void tick(long atMs, boolean isCommanded) {
        commandedMs = isCommanded ? Optional.of(commandedMs.orElse(atMs)) : Optional.empty();
        boolean nothingToDo = wanted.isEmpty() && (given.isEmpty() || mayAreasCome(atMs));
        if (isCommanded && !busy && !nothingToDo && atMs >= notBeforeMs && !settled.equals(Optional.of(wanted))) {
            busy = true;
            notBeforeMs = atMs + AGAIN_MS;
            List<MissionItem> fence = wanted;
            Results.when(base.held(id, HeldKind.FENCE), thread, held -> compare(fence, held), this::failed);
        }
    }

    private boolean mayAreasCome(long atMs) {
        return !hadAreas && atMs - commandedMs.orElse(atMs) < AREAS_COME_MS;
    }

    private void compare(List<MissionItem> fence, List<MissionItem> held) {
        boolean isOurs = given.contains(FenceItems.text(held));
        if (!fence.equals(wanted)) { // it has changed while the vehicle was read
            busy = false;
            notBeforeMs = 0;
        } else if (fence.isEmpty() && (isOurs || held.isEmpty())) {
            remove();
        } else if (fence.isEmpty()) { // its owner has put it there since
            give(List.of());
            done(fence);
        } else if (FenceItems.isHeld(fence, held)) {
            heed(fence);
        } else {
            if (!held.isEmpty() && !isOurs) {
                alarm.accept("vehicle " + id + " held a fence of its own with " + held.size()
                        + " corners; the fence and no-go areas of this session take its place");
            }
            give(isOurs ? List.of(FenceItems.text(held), FenceItems.text(fence)) : List.of(FenceItems.text(fence)));
            Results.when(base.replace(id, HeldKind.FENCE, fence), thread, there -> heed(fence), this::failed);
        }
    }

    /** It may hold one of these fences from now on that this machine gave to it. */
    private void give(List<String> fences) {
        if (!fences.equals(given)) {
            given = fences;
            keep.accept(fences);
        }
    }

    /** Sets what of its parameters is another, in their order. */
    private void heed(List<MissionItem> fence) {
        set(new ArrayList<>(IN_FORCE.entrySet()).iterator(), () -> {
            give(List.of(FenceItems.text(fence)));
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

    /** Takes away what this machine has put there: first it is no longer heeded. */
    private void remove() {
        set(
                List.of(Map.entry(ENABLE, 0)).iterator(),
                () -> Results.when(
                        base.replace(id, HeldKind.FENCE, List.of()),
                        thread,
                        nothing -> {
                            give(List.of());
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
