package org.sami.mavlink.mission;

import io.dronefleet.mavlink.common.MavMissionResult;
import io.dronefleet.mavlink.common.MavMissionType;
import io.dronefleet.mavlink.common.MissionAck;
import io.dronefleet.mavlink.common.MissionCount;
import io.dronefleet.mavlink.common.MissionItemInt;
import io.dronefleet.mavlink.common.MissionRequestInt;
import io.dronefleet.mavlink.common.MissionRequestList;
import io.dronefleet.mavlink.util.EnumValue;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.function.Consumer;
import org.sami.mavlink.vehicle.VehicleId;

/**
 * Reads one list that a vehicle holds, by the mission protocol: asks how many items there are, then for one after the other, and again for what does not come.
 * Only one transfer with a vehicle may run at a time, as the protocol has no other way to tell them apart. Used by one thread.
 *
 * <p>Source: the mission protocol of MAVLink's documentation (times and numbers of tries are its).
 */
public final class ListDownload {
    private static final long ANSWER_MS = 1_500;
    private static final int TRIES = 5;
    private static final int MOST_ITEMS = 10_000; // more fits into no autopilot

    private final VehicleId vehicle;
    private final HeldKind kind;
    private final Consumer<Object> send;
    private final List<MissionItem> items = new ArrayList<>();
    private Optional<Integer> count = Optional.empty();
    private Optional<String> failure = Optional.empty();
    private boolean done;
    private int tries;
    private long againMs;

    /**
     * A transfer that is not begun yet.
     *
     * @param send sends a message of the library to the vehicle; may lose it
     */
    public ListDownload(VehicleId vehicle, HeldKind kind, Consumer<Object> send) {
        this.vehicle = Objects.requireNonNull(vehicle, "vehicle");
        this.kind = Objects.requireNonNull(kind, "kind");
        this.send = Objects.requireNonNull(send, "send");
    }

    /** Which vehicle is asked. */
    public VehicleId vehicle() {
        return vehicle;
    }

    /** Asks for the first time. */
    public void begin(long nowMs) {
        ask(nowMs);
    }

    /** Asks again where an answer is overdue. */
    public void tick(long nowMs) {
        if (isOver() || nowMs < againMs) {
            return;
        }
        if (tries == TRIES) {
            failure = Optional.of("vehicle " + vehicle + " does not answer when it is asked for its " + kind.words()
                    + count.map(all -> ": it sent " + items.size() + " of " + all + " items")
                            .orElse(""));
            return;
        }
        ask(nowMs);
    }

    private void ask(long nowMs) {
        tries++;
        againMs = nowMs + ANSWER_MS;
        send.accept(
                count.isEmpty()
                        ? MissionRequestList.builder()
                                .targetSystem(vehicle.system())
                                .targetComponent(vehicle.component())
                                .missionType(kind.type())
                                .build()
                        : MissionRequestInt.builder()
                                .targetSystem(vehicle.system())
                                .targetComponent(vehicle.component())
                                .seq(items.size())
                                .missionType(kind.type())
                                .build());
    }

    /** Takes what the vehicle sent; anything that is no part of this transfer changes nothing. */
    public void take(Object message, long nowMs) {
        if (isOver()) {
            return;
        }
        if (message instanceof MissionCount all && count.isEmpty() && isOurs(all.missionType())) {
            counted(all.count(), nowMs);
        } else if (message instanceof MissionItemInt item
                && count.isPresent()
                && isOurs(item.missionType())
                && item.seq() == items.size()) {
            items.add(MissionItem.of(item));
            next(nowMs);
        } else if (message instanceof MissionAck ack
                && isOurs(ack.missionType())
                && ack.type().entry() != MavMissionResult.MAV_MISSION_ACCEPTED) {
            MavMissionResult why = ack.type().entry();
            failure = Optional.of("vehicle " + vehicle + " refuses to send its " + kind.words() + ": "
                    + (why == null ? "result " + ack.type().value() : why.name()));
        }
    }

    private boolean isOurs(EnumValue<MavMissionType> type) {
        return type.entry() == kind.type();
    }

    private void counted(int all, long nowMs) {
        if (all > MOST_ITEMS) {
            failure = Optional.of("vehicle " + vehicle + " says that its " + kind.words() + " has " + all
                    + " items; at most " + MOST_ITEMS + " are read");
            return;
        }
        count = Optional.of(all);
        next(nowMs);
    }

    private void next(long nowMs) {
        if (count.filter(all -> items.size() < all).isPresent()) {
            tries = 0;
            ask(nowMs);
        } else {
            done = true;
            send.accept(MissionAck.builder()
                    .targetSystem(vehicle.system())
                    .targetComponent(vehicle.component())
                    .type(MavMissionResult.MAV_MISSION_ACCEPTED)
                    .missionType(kind.type())
                    .build());
        }
    }

    /** Whether it has ended, well or not. */
    public boolean isOver() {
        return done || failure.isPresent();
    }

    /** Why it failed, in words for people; empty where it did not. */
    public Optional<String> failure() {
        return failure;
    }

    /** What the vehicle holds, in its order; so far, until the transfer is over. */
    public List<MissionItem> items() {
        return List.copyOf(items);
    }
}
