package org.sami.mavlink.mission;

import io.dronefleet.mavlink.common.MavMissionResult;
import io.dronefleet.mavlink.common.MavMissionType;
import io.dronefleet.mavlink.common.MissionAck;
import io.dronefleet.mavlink.common.MissionCount;
import io.dronefleet.mavlink.common.MissionItemInt;
import io.dronefleet.mavlink.common.MissionRequestInt;
import io.dronefleet.mavlink.common.MissionRequestList;
import io.dronefleet.mavlink.util.EnumValue;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.TreeMap;
import java.util.function.Consumer;
import org.sami.mavlink.vehicle.VehicleId;

/**
 * Reads one list that a vehicle holds, by the mission protocol: asks how many items there are, then for a few at a time, and again for what does not come.
 *
 * <p>Source: the mission protocol of MAVLink's documentation. Differs from it: several items are asked for ahead of their answers, as each answer names its item. Of a
 * list of more than {@link #MANY}, which only autopilots with a memory card hold, more and more, until one is lost.
 */
public final class ListDownload extends AbstractListTransfer {
    private static final int TRIES = 8; // to ask how many there are
    private static final long SILENCE_MS = 8_000;
    private static final int AHEAD = 5;
    private static final int MANY = 650;
    private static final int MOST_AHEAD = 30;
    private static final int MOST_ITEMS = 10_000; // more fits into no autopilot

    private final VehicleId vehicle;
    private final HeldKind kind;
    private final Consumer<Object> send;
    private final AnswerTime time = new AnswerTime();
    private final TreeMap<Integer, MissionItem> items = new TreeMap<>();
    private final TreeMap<Integer, Asked> open = new TreeMap<>();
    private Optional<Integer> count = Optional.empty();
    private int tries;
    private int ahead = AHEAD;
    private int unasked; // the first item that was never asked for
    private long askedMs;
    private long progressMs;
    private boolean hasNoSuchItem; // so it answered since the last item came

    /** An item that was asked for {@code tries} times, last at a time. */
    private record Asked(int tries, long atMs) {}

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

    @Override
    public void begin(long nowMs) {
        askHowMany(nowMs);
    }

    @Override
    public void tick(long nowMs) {
        if (isOver()) {
            return;
        }
        if (count.isEmpty()) {
            if (nowMs >= askedMs + time.waitMs(tries)) {
                if (tries == TRIES) {
                    silent();
                } else {
                    askHowMany(nowMs);
                }
            }
        } else if (nowMs - progressMs > SILENCE_MS) {
            silent();
        } else {
            for (Map.Entry<Integer, Asked> each : List.copyOf(open.entrySet())) {
                Asked asked = each.getValue();
                if (nowMs >= asked.atMs() + time.waitMs(asked.tries() - 1)) {
                    ahead = AHEAD;
                    ask(each.getKey(), asked.tries() + 1, nowMs);
                }
            }
        }
    }

    private void silent() {
        String came = count.map(all -> ": it sent " + items.size() + " of " + all + " items")
                .orElse("");
        fail(
                hasNoSuchItem && count.isPresent()
                        ? "vehicle " + vehicle + " changed its " + kind.words() + " while it was read" + came
                                + " and has no others any longer"
                        : "vehicle " + vehicle + " does not answer when it is asked for its " + kind.words() + came);
    }

    private void askHowMany(long nowMs) {
        tries++;
        askedMs = nowMs;
        send.accept(MissionRequestList.builder()
                .targetSystem(vehicle.system())
                .targetComponent(vehicle.component())
                .missionType(kind.type())
                .build());
    }

    private void ask(int item, int again, long nowMs) {
        open.put(item, new Asked(again, nowMs));
        send.accept(MissionRequestInt.builder()
                .targetSystem(vehicle.system())
                .targetComponent(vehicle.component())
                .seq(item)
                .missionType(kind.type())
                .build());
    }

    @Override
    public void take(Object message, long nowMs) {
        if (isOver()) {
            return;
        }
        if (message instanceof MissionCount all && count.isEmpty() && isOurs(all.missionType())) {
            counted(all.count(), nowMs);
        } else if (message instanceof MissionItemInt item && isOurs(item.missionType())) {
            Asked asked = open.remove(item.seq());
            if (asked != null) {
                if (asked.tries() == 1) {
                    time.answered(nowMs - asked.atMs());
                    ahead = count.orElse(0) > MANY ? Math.min(MOST_AHEAD, ahead + 1) : AHEAD;
                }
                came(item, nowMs);
            }
        } else if (message instanceof MissionAck ack
                && isOurs(ack.missionType())
                && ack.type().entry() == MavMissionResult.MAV_MISSION_INVALID_SEQUENCE) {
            hasNoSuchItem = true; // or it is a late answer to an upload before
        } else if (message instanceof MissionAck ack
                && isOurs(ack.missionType())
                && ack.type().entry() != MavMissionResult.MAV_MISSION_ACCEPTED
                && ack.type().entry() != MavMissionResult.MAV_MISSION_ERROR) { // these two may be late answers, too
            fail(new ListRefusedException(
                    "vehicle " + vehicle + " refuses to send its " + kind.words() + ": ", ack.type()));
        }
    }

    private void came(MissionItemInt item, long nowMs) {
        try {
            items.put(item.seq(), MissionItem.of(item));
            next(nowMs);
        } catch (IllegalArgumentException e) {
            fail("vehicle " + vehicle + " sends a " + kind.words() + " that cannot be: " + e.getMessage());
        }
    }

    private boolean isOurs(EnumValue<MavMissionType> type) {
        return type.entry() == kind.type();
    }

    private void counted(int all, long nowMs) {
        if (all > MOST_ITEMS) {
            fail("vehicle " + vehicle + " says that its " + kind.words() + " has " + all + " items; at most "
                    + MOST_ITEMS + " are read");
            return;
        }
        if (tries == 1) {
            time.answered(nowMs - askedMs);
        }
        count = Optional.of(all);
        next(nowMs);
    }

    private void next(long nowMs) {
        progressMs = nowMs;
        hasNoSuchItem = false;
        int all = count.orElse(0);
        if (items.size() == all) {
            succeed();
            send.accept(MissionAck.builder()
                    .targetSystem(vehicle.system())
                    .targetComponent(vehicle.component())
                    .type(MavMissionResult.MAV_MISSION_ACCEPTED)
                    .missionType(kind.type())
                    .build());
            return;
        }
        while (unasked < all && open.size() < ahead) {
            ask(unasked, 1, nowMs);
            unasked++;
        }
    }

    /** What the vehicle holds, in its order; so far, until the transfer is over. */
    public List<MissionItem> items() {
        return List.copyOf(items.values());
    }
}
