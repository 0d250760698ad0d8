package org.sami.mavlink.onboard;

import io.dronefleet.mavlink.common.MavMissionResult;
import io.dronefleet.mavlink.common.MavMissionType;
import io.dronefleet.mavlink.common.MissionAck;
import io.dronefleet.mavlink.common.MissionClearAll;
import io.dronefleet.mavlink.common.MissionCount;
import io.dronefleet.mavlink.common.MissionItemInt;
import io.dronefleet.mavlink.common.MissionRequest;
import io.dronefleet.mavlink.common.MissionRequestInt;
import io.dronefleet.mavlink.common.MissionRequestList;
import io.dronefleet.mavlink.common.MissionWritePartialList;
import io.dronefleet.mavlink.util.EnumValue;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.function.Consumer;
import org.sami.mavlink.mission.HeldKind;
import org.sami.mavlink.mission.MissionItem;
import org.sami.mavlink.vehicle.VehicleId;

/**
 * A vehicle's end of the mission protocol: sends its lists to whoever asks, and takes new ones, item after item, whole or not at all. One station may send at a
 * time; others are refused meanwhile. Used by one thread.
 *
 * <p>Source: the mission protocol of MAVLink's documentation; times as ArduPilot has them.
 */
public final class OnboardLists {
    private static final long AGAIN_MS = 1_000;
    private static final long GIVE_UP_MS = 8_000;

    private final int capacity;
    private final long paceMs;
    private final ListKeeper keeper;
    private final Consumer<Object> send;
    private final Map<HeldKind, List<MissionItem>> lists = new EnumMap<>(HeldKind.class);
    private Optional<Arriving> arriving = Optional.empty();
    private Optional<Arriving> taken = Optional.empty(); // the last list, whose station may not have heard of it

    /** A list that is being received. */
    private static final class Arriving {
        private final VehicleId station;
        private final HeldKind kind;
        private final List<MissionItem> items;
        private final int to;
        private int next;
        private long askMs;
        private long heardMs;

        Arriving(VehicleId station, HeldKind kind, List<MissionItem> items, int from, int to, long nowMs) {
            this.station = station;
            this.kind = kind;
            this.items = items;
            this.next = from;
            this.to = to;
            askMs = nowMs;
            heardMs = nowMs;
        }

        boolean isLastItem(VehicleId from, MissionItemInt message) {
            return station.equals(from) && kind.type() == message.missionType().entry() && message.seq() == to - 1;
        }
    }

    /**
     * Empty lists.
     *
     * @param capacity how many items each list may have
     * @param paceMs how long the next item is asked for after one came, in milliseconds
     * @param send sends a message of the library to ground stations; may lose it
     */
    public OnboardLists(int capacity, long paceMs, ListKeeper keeper, Consumer<Object> send) {
        this.capacity = capacity;
        this.paceMs = paceMs;
        this.keeper = Objects.requireNonNull(keeper, "keeper");
        this.send = Objects.requireNonNull(send, "send");
    }

    /** What is held of a kind. */
    public List<MissionItem> held(HeldKind kind) {
        return lists.getOrDefault(kind, List.of());
    }

    /** Puts a list there from aboard; the keeper is not asked. */
    public void put(HeldKind kind, List<MissionItem> items) {
        lists.put(kind, List.copyOf(items));
    }

    /** Takes what a station sent; anything that is no part of this protocol changes nothing. */
    @SuppressWarnings("deprecation") // stations that are older ask by the older message
    public void take(VehicleId station, Object message, long nowMs) {
        if (message instanceof MissionRequestList asked) {
            HeldKind.of(asked.missionType())
                    .ifPresentOrElse(
                            kind -> send.accept(MissionCount.builder()
                                    .targetSystem(station.system())
                                    .targetComponent(station.component())
                                    .count(held(kind).size())
                                    .missionType(kind.type())
                                    .build()),
                            () -> acknowledge(station, asked.missionType(), MavMissionResult.MAV_MISSION_UNSUPPORTED));
        } else if (message instanceof MissionRequestInt asked) {
            sendItem(station, asked.missionType(), asked.seq());
        } else if (message instanceof MissionRequest asked) {
            sendItem(station, asked.missionType(), asked.seq());
        } else if (message instanceof MissionCount count) {
            begin(station, count.missionType(), 0, count.count(), false, nowMs);
        } else if (message instanceof MissionWritePartialList part) {
            begin(station, part.missionType(), part.startIndex(), part.endIndex() + 1, true, nowMs);
        } else if (message instanceof MissionItemInt item) {
            received(station, item, nowMs);
        } else if (message instanceof MissionClearAll all) {
            clear(station, all.missionType());
        }
    }

    private void sendItem(VehicleId station, EnumValue<MavMissionType> type, int number) {
        Optional<MissionItem> item = HeldKind.of(type)
                .map(this::held)
                .filter(list -> number < list.size())
                .map(list -> list.get(number));
        item.ifPresentOrElse(
                known -> send.accept(known.message(station, HeldKind.of(type).orElseThrow())),
                () -> acknowledge(station, type, MavMissionResult.MAV_MISSION_INVALID_SEQUENCE));
    }

    private void begin(VehicleId station, EnumValue<MavMissionType> type, int from, int to, boolean part, long nowMs) {
        Optional<HeldKind> kind = HeldKind.of(type);
        Optional<ListKeeper.Refusal> whyNot = kind.flatMap(known -> keeper.whyNoList(station, known, to));
        if (kind.isEmpty()) {
            acknowledge(station, type, MavMissionResult.MAV_MISSION_UNSUPPORTED);
        } else if (arriving.filter(other -> !other.station.equals(station)).isPresent()) {
            acknowledge(station, type, MavMissionResult.MAV_MISSION_DENIED);
        } else if (whyNot.isPresent()) {
            acknowledge(station, type, result(whyNot.get()));
        } else if (to > capacity) {
            acknowledge(station, type, MavMissionResult.MAV_MISSION_NO_SPACE);
        } else if (part && (from < 0 || from >= to || to > held(kind.get()).size())) {
            acknowledge(station, type, MavMissionResult.MAV_MISSION_ERROR);
        } else if (to == 0) {
            arriving = Optional.empty();
            change(kind.get(), List.of());
            acknowledge(station, type, MavMissionResult.MAV_MISSION_ACCEPTED);
        } else {
            List<MissionItem> items = part ? new ArrayList<>(held(kind.get())) : new ArrayList<>();
            arriving = Optional.of(new Arriving(station, kind.get(), items, from, to, nowMs));
            taken = Optional.empty();
        }
    }

    private void received(VehicleId station, MissionItemInt message, long nowMs) {
        if (arriving.isEmpty()) {
            boolean isRepeated =
                    taken.filter(list -> list.isLastItem(station, message)).isPresent();
            acknowledge(
                    station,
                    message.missionType(),
                    isRepeated ? MavMissionResult.MAV_MISSION_ACCEPTED : MavMissionResult.MAV_MISSION_ERROR);
            return;
        }
        Arriving list = arriving.get();
        if (message.seq() != list.next
                || list.kind.type() != message.missionType().entry()) {
            acknowledge(station, message.missionType(), MavMissionResult.MAV_MISSION_INVALID_SEQUENCE);
            return;
        }
        if (!list.station.equals(station)) {
            acknowledge(station, message.missionType(), MavMissionResult.MAV_MISSION_DENIED);
            return;
        }
        Optional<MavMissionResult> refused = refusal(list, message);
        if (refused.isPresent()) {
            arriving = Optional.empty();
            acknowledge(station, message.missionType(), refused.get());
            return;
        }
        list.next++;
        list.heardMs = nowMs;
        list.askMs = nowMs + paceMs;
        if (list.next == list.to) {
            arriving = Optional.empty();
            Optional<ListKeeper.Refusal> whyNot = keeper.whyNoList(
                            station, list.kind, list.items.size()) // it may be another's by now
                    .or(() -> keeper.whyNotWhole(list.kind, list.items));
            if (whyNot.isEmpty()) {
                change(list.kind, list.items);
                taken = Optional.of(list);
            }
            acknowledge(
                    station,
                    message.missionType(),
                    whyNot.map(OnboardLists::result).orElse(MavMissionResult.MAV_MISSION_ACCEPTED));
        }
    }

    /** Takes an item into the list that arrives; why not, where it cannot be. */
    private Optional<MavMissionResult> refusal(Arriving list, MissionItemInt message) {
        MissionItem item;
        try {
            item = MissionItem.of(message);
        } catch (IllegalArgumentException e) {
            keeper.unreadable(list.kind, Objects.toString(e.getMessage()));
            return Optional.of(MavMissionResult.MAV_MISSION_INVALID_PARAM5_X);
        }
        Optional<ListKeeper.Refusal> why = keeper.whyNot(list.kind, item);
        if (why.isEmpty()) {
            if (list.next < list.items.size()) {
                list.items.set(list.next, item);
            } else {
                list.items.add(item);
            }
        }
        return why.map(OnboardLists::result);
    }

    private static MavMissionResult result(ListKeeper.Refusal refused) {
        return switch (refused) {
            case UNSUPPORTED -> MavMissionResult.MAV_MISSION_UNSUPPORTED;
            case UNSUPPORTED_FRAME -> MavMissionResult.MAV_MISSION_UNSUPPORTED_FRAME;
            case NO_SPACE -> MavMissionResult.MAV_MISSION_NO_SPACE;
            case INVALID -> MavMissionResult.MAV_MISSION_INVALID;
            case DENIED -> MavMissionResult.MAV_MISSION_DENIED;
        };
    }

    private void clear(VehicleId station, EnumValue<MavMissionType> type) {
        if (arriving.isPresent()) {
            acknowledge(station, type, MavMissionResult.MAV_MISSION_DENIED);
            return;
        }
        List<HeldKind> full = Arrays.stream(HeldKind.values())
                .filter(kind -> type.entry() == MavMissionType.MAV_MISSION_TYPE_ALL || type.entry() == kind.type())
                .filter(kind -> !held(kind).isEmpty())
                .toList();
        Optional<ListKeeper.Refusal> refused = full.stream()
                .flatMap(kind -> keeper.whyNoList(station, kind, 0).stream())
                .findFirst();
        if (refused.isEmpty()) {
            full.forEach(kind -> change(kind, List.of()));
        }
        acknowledge(station, type, refused.map(OnboardLists::result).orElse(MavMissionResult.MAV_MISSION_ACCEPTED));
    }

    private void change(HeldKind kind, List<MissionItem> items) {
        taken = Optional.empty();
        put(kind, items);
        keeper.changed(kind, held(kind));
    }

    /** Asks for the next item, and again; gives up where none comes. */
    public void tick(long nowMs) {
        if (arriving.isEmpty() || nowMs < arriving.get().askMs) {
            return;
        }
        Arriving list = arriving.get();
        if (nowMs - list.heardMs > GIVE_UP_MS) {
            arriving = Optional.empty();
            acknowledge(list.station, EnumValue.of(list.kind.type()), MavMissionResult.MAV_MISSION_OPERATION_CANCELLED);
            return;
        }
        list.askMs = nowMs + AGAIN_MS;
        send.accept(MissionRequestInt.builder()
                .targetSystem(list.station.system())
                .targetComponent(list.station.component())
                .seq(list.next)
                .missionType(list.kind.type())
                .build());
    }

    private void acknowledge(VehicleId station, EnumValue<MavMissionType> type, MavMissionResult result) {
        send.accept(MissionAck.builder()
                .targetSystem(station.system())
                .targetComponent(station.component())
                .type(result)
                .missionType(type)
                .build());
    }
}
