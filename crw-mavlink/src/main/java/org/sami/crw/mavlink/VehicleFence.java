package org.sami.crw.mavlink;

import java.util.ArrayList;
import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.Executor;
import java.util.function.Consumer;
import java.util.function.IntUnaryOperator;
import org.sami.mavlink.base.MavlinkBase;
import org.sami.mavlink.command.VehicleCommand;
import org.sami.mavlink.mission.HeldKind;
import org.sami.mavlink.mission.MissionItem;
import org.sami.mavlink.vehicle.VehicleId;

/**
 * The session's fence and no-go areas as the vehicle's own fence, on which it acts without a base: compared with what the vehicle holds once the base commands
 * it, sent where it differs, and read back equal. Its parameters are set and read back with it. As long as the session has no areas, the vehicle's fence is its
 * owner's; one that an earlier session on this machine has left there is taken away. For the gateway's thread.
 *
 * <p>Source: ArduPilot's parameters {@code FENCE_TYPE} (bits 1: highest altitude, 2: circle about its home, 4: polygons, 8: lowest altitude; boats have 4 alone, copters
 * keep their altitudes), {@code FENCE_ACTION} (boats 2: mode HOLD; copters 4: BRAKE or land) and {@code FENCE_ENABLE}. A command (DO_FENCE_ENABLE, 207) and a switch of the
 * radio control put it out of force and leave them as they are; {@code SYS_STATUS} says whether it is in force.
 */
final class VehicleFence {
    private static final long AGAIN_MS = 30_000; // after a fault
    private static final long AREAS_COME_MS = 10_000; // a session may load its project after it commands the vehicle
    private static final String ENABLE = "FENCE_ENABLE";
    private static final String TYPE = "FENCE_TYPE";
    private static final String TOTAL =
            "FENCE_TOTAL"; // how much it holds; another station that clears or replaces it changes that
    private static final String BY_ITSELF =
            "FENCE_AUTOENABLE"; // not 0: it switches its fence as it takes off, lands or is armed
    private static final long SWITCHED_MS = 2_000; // in which it says what parameter has put it out of force
    private static final long IN_FORCE_MS =
            20_000; // within which it says that its fence is in force, over a slow link too
    private static final int CIRCLE = 2;
    private static final int POLYGONS = 4;
    private static final int LOWEST = 8;
    private static final int HOLD_BOAT = 2; // its mode HOLD: motors off
    private static final int BRAKE_COPTER = 4; // its mode BRAKE, or a landing where it cannot

    private final MavlinkBase base;
    private final VehicleId id;
    private final boolean flies;
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
    private boolean hasOtherKinds; // than those that were in force when it was switched on
    private boolean mustSwitch; // its parameters alone do not put it in force again
    private boolean isWatched; // whether it is in force; not where it switches its fence by itself
    private int kinds = POLYGONS; // of its fence, bits of FENCE_TYPE
    private boolean isOff; // as it says
    private boolean wasOn; // since it was set
    private long sinceMs; // that it is off, or was set
    private final WatchedParameters watched;
    private long nowMs;
    private long changedMs = -AGAIN_MS; // when others were last seen to have changed it

    /** The parameters of a fence in force, in the order in which they are set: each new value by the present one. */
    private Map<String, IntUnaryOperator> inForce() {
        Map<String, IntUnaryOperator> values = new LinkedHashMap<>();
        values.put(TYPE, now -> flies ? (now | POLYGONS) & ~CIRCLE : POLYGONS);
        values.put("FENCE_ACTION", now -> flies ? BRAKE_COPTER : HOLD_BOAT);
        values.put(ENABLE, now -> 1);
        return values;
    }

    /**
     * Nothing is known or asked for yet.
     *
     * @param flies whether it is a copter
     * @param alarm receives faults, in words for the operator
     * @param given the fences that earlier sessions on this machine gave to the vehicle and did not take away
     * @param keep receives these fences when they change, for later sessions
     */
    VehicleFence(
            MavlinkBase base,
            VehicleId id,
            boolean flies,
            Executor thread,
            Consumer<String> alarm,
            List<String> given,
            Consumer<List<String>> keep) {
        this.base = base;
        this.id = id;
        this.flies = flies;
        this.thread = thread;
        this.alarm = alarm;
        this.given = given;
        this.keep = keep;
        watched = new WatchedParameters(base, id, thread, (name, value, words) -> changedByOthers(words));
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
        watched.forget();
    }

    /** A base has come: what the vehicle was read to hold may be another since. */
    void askSoon() {
        watched.askSoon();
    }

    /** The vehicle has said what a parameter is, to whomever. */
    void reported(String name, double value) {
        watched.reported(name, value);
    }

    /** Whether the fence that it holds is in force, as it says; empty where it does not say. */
    void inForce(Optional<Boolean> now) {
        boolean nowOff = now.filter(on -> !on).isPresent();
        sinceMs = nowOff && !isOff ? nowMs : sinceMs;
        isOff = nowOff;
        wasOn |= now.orElse(false);
    }

    /** Out of force while its parameters have it in force: a command or a switch of the radio control did that. */
    private void look() {
        boolean isSet = settled.filter(fence -> !fence.isEmpty()).isPresent() && !busy;
        if (isSet && isWatched && isOff && nowMs - sinceMs >= (wasOn ? SWITCHED_MS : IN_FORCE_MS)) {
            mustSwitch = true;
            changedByOthers("switched off by a command or by a switch of its radio control");
        }
    }

    private void changedByOthers(String words) {
        if (settled.isPresent() && !busy) {
            settled = Optional.empty();
            notBeforeMs = changedMs + AGAIN_MS; // two stations that set it in turn do not fill the link
            changedMs = nowMs;
            alarm.accept("the fence of vehicle " + id + " was changed by somebody else (" + words
                    + "); that of this session is set again"
                    + (commandedMs.isPresent() ? "" : " once it is commanded from here"));
        }
    }

    /** Brings the vehicle to hold the fence that is asked for, as long as the base commands it. To be called often. */
    void tick(long atMs, boolean isCommanded) {
        nowMs = atMs;
        watched.tick(atMs, isCommanded && !busy);
        look();
        commandedMs = isCommanded ? Optional.of(commandedMs.orElse(atMs)) : Optional.empty();
        boolean nothingToDo = wanted.isEmpty() && (given.isEmpty() || mayAreasCome(atMs));
        if (isCommanded && !busy && !nothingToDo && atMs >= notBeforeMs && !settled.equals(Optional.of(wanted))) {
            busy = true;
            watched.pause();
            watched.forget();
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
        set(new ArrayList<>(inForce().entrySet()).iterator(), () -> {
            give(List.of(FenceItems.text(fence)));
            if (mustSwitch) {
                switchOn(fence);
            } else if (hasOtherKinds) {
                putKindsInForce(fence);
            } else {
                done(fence);
            }
        });
    }

    /** A fence that was in force before keeps the kinds that it had then, until it is switched on anew. */
    private void putKindsInForce(List<MissionItem> fence) {
        Results.when(
                base.parameter(id, BY_ITSELF),
                thread,
                when -> {
                    if (when == 0) {
                        switchOn(fence);
                    } else {
                        hasOtherKinds = false; // it puts them in force when it takes off
                        done(fence);
                    }
                },
                unknown -> switchOn(fence)); // not all firmware does it by itself
    }

    /** Whoever has set it to 1 has no effect with that where it was 1. */
    private void switchOn(List<MissionItem> fence) {
        Results.when(
                base.command(id, VehicleCommand.fenceOn(kinds)),
                thread,
                outcome -> {
                    if (outcome.isAccepted()) {
                        mustSwitch = false;
                        hasOtherKinds = false;
                        done(fence);
                    } else {
                        failed(outcome.inWords());
                    }
                },
                this::failed);
    }

    private void set(Iterator<Map.Entry<String, IntUnaryOperator>> values, Runnable then) {
        if (!values.hasNext()) {
            then.run();
            return;
        }
        Map.Entry<String, IntUnaryOperator> value = values.next();
        Results.when(
                base.parameter(id, value.getKey()),
                thread,
                now -> {
                    int present = (int) Math.round(now);
                    int asked = value.getValue().applyAsInt(present);
                    watched.holds(value.getKey(), asked);
                    kinds = value.getKey().equals(TYPE) ? asked & ~LOWEST : kinds; // on the ground it is below that
                    if (present == asked) {
                        set(values, then);
                    } else {
                        Results.when(
                                base.setParameter(id, value.getKey(), asked),
                                thread,
                                set -> {
                                    hasOtherKinds = value.getKey().equals(TYPE)
                                            || (hasOtherKinds && !value.getKey().equals(ENABLE));
                                    set(values, then);
                                },
                                this::failed);
                    }
                },
                this::failed);
    }

    /** Takes away what this machine has put there: first it is no longer heeded. */
    private void remove() {
        set(
                List.<Map.Entry<String, IntUnaryOperator>>of(Map.entry(ENABLE, now -> 0))
                        .iterator(),
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
        isWatched = false;
        wasOn = false;
        sinceMs = nowMs;
        if (fence.isEmpty()) {
            watched.forget();
        } else {
            watched.resume();
            Results.when(base.parameter(id, TOTAL), thread, this::holds, unknown -> {}); // not all firmware says it
            Results.when(
                    base.parameter(id, BY_ITSELF), thread, when -> isWatched = when == 0, unknown -> isWatched = true);
        }
    }

    private void holds(double total) {
        if (settled.isPresent() && !busy) {
            watched.holds(TOTAL, total);
        }
    }

    private void failed(String why) {
        busy = false;
        if (!why.equals(lastFault)) {
            lastFault = why;
            alarm.accept("vehicle " + id + " does not keep to the fence of this session by itself: " + why);
        }
    }
}
