package org.sami.mavlink.mission;

import io.dronefleet.mavlink.common.MavMissionResult;
import io.dronefleet.mavlink.common.MavMissionType;
import io.dronefleet.mavlink.common.MissionAck;
import io.dronefleet.mavlink.common.MissionCount;
import io.dronefleet.mavlink.common.MissionRequest;
import io.dronefleet.mavlink.common.MissionRequestInt;
import io.dronefleet.mavlink.common.MissionWritePartialList;
import io.dronefleet.mavlink.util.EnumValue;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Consumer;
import org.sami.mavlink.vehicle.VehicleId;

/**
 * Sends a list, or a part of one that the vehicle holds already, by the mission protocol: says how many items there are, then sends what the vehicle asks for.
 * That it ended well says only that the vehicle took the last item; what it holds is read back ({@link ListReplacement}).
 *
 * <p>Source: the mission protocol of MAVLink's documentation. Differs from it: where the vehicle's next question is overdue, the items that it must want next
 * are sent without one. Autopilots ask again only after a second, and ignore items that they did not expect. Of a part, and of a list of more than {@link #MANY},
 * up to {@link #AHEAD} items are sent before they are asked for, until one is lost: an autopilot that drives along the list begins its leg again with each of its
 * rounds in which an item comes, and asks for 50 items a second at most.
 */
final class ListUpload extends AbstractListTransfer {
    private static final int TRIES = 8; // to say how many there are
    private static final int LAST_TRIES = 4; // to send the last item, whose acknowledgement may be lost
    private static final int ROUNDS = 4;
    private static final long SILENCE_MS = 10_000; // the vehicle gives up after 8 s itself
    private static final int MOST_PUSHED = 6;
    private static final int MANY = 600;
    private static final int AHEAD = 60; // 3 kB, which fit into the buffer of a port
    private static final long HASTE_WAIT_MS = 500; // what it wants is on its way already
    private static final double NEW_PART = 0.1;
    private static final double LITTLE_LOST = 0.02;
    private static final double MUCH_LOST = 0.1;

    private final VehicleId vehicle;
    private final HeldKind kind;
    private final List<MissionItem> items;
    private final int from;
    private final int to;
    private final Consumer<Object> send;
    private final AnswerTime time = new AnswerTime();
    private boolean taken;
    private int rounds;
    private boolean hastens; // sends before it is asked
    private Optional<IllegalStateException> notReady = Optional.empty();
    private Optional<String> unexpected =
            Optional.empty(); // its answer, in this round, to an item that it did not expect
    private double lost; // the part of the items, lately, that had to be sent again
    private int tries;
    private int asked; // the item that was asked for last
    private int sent; // the highest item that was sent
    private long sentMs;
    private long progressMs;

    /**
     * A transfer that is not begun yet.
     *
     * @param items the whole list, each item at its number
     * @param from the first item that is sent; with {@code to} the whole list, or a part of one that the vehicle holds at this length
     * @param to the item after the last that is sent
     */
    ListUpload(VehicleId vehicle, HeldKind kind, List<MissionItem> items, int from, int to, Consumer<Object> send) {
        this.vehicle = vehicle;
        this.kind = kind;
        this.items = List.copyOf(items);
        this.from = from;
        this.to = to;
        this.send = send;
        asked = from - 1;
    }

    @Override
    public void begin(long nowMs) {
        rounds++;
        hastens = rounds == 1 && (!isWhole() || items.size() > MANY);
        tries = 0;
        asked = from - 1;
        sent = from - 1;
        unexpected = Optional.empty();
        progressMs = nowMs;
        announce(nowMs);
    }

    private boolean isWhole() {
        return from == 0 && to == items.size();
    }

    /** Whether it sends a part of the list alone. */
    boolean isPart() {
        return !isWhole();
    }

    private void announce(long nowMs) {
        tries++;
        sentMs = nowMs;
        send.accept(
                isWhole()
                        ? MissionCount.builder()
                                .targetSystem(vehicle.system())
                                .targetComponent(vehicle.component())
                                .count(items.size())
                                .missionType(kind.type())
                                .build()
                        : MissionWritePartialList.builder()
                                .targetSystem(vehicle.system())
                                .targetComponent(vehicle.component())
                                .startIndex(from)
                                .endIndex(to - 1)
                                .missionType(kind.type())
                                .build());
    }

    private void sendFrom(int item, int more) {
        for (int i = item; i <= Math.min(to - 1, item + more); i++) {
            send.accept(items.get(i).message(vehicle, kind));
            sent = Math.max(sent, i);
        }
    }

    /** How many items are sent in addition to the requested one: on a link that loses messages, a lost request then costs less time. */
    private int ahead() {
        return lost > MUCH_LOST ? 2 : lost > LITTLE_LOST ? 1 : 0;
    }

    @Override
    public void tick(long nowMs) {
        if (isOver()) {
            return;
        }
        boolean began = asked >= from;
        long waitMs = time.waitMs(began ? tries : tries - 1);
        if (nowMs < sentMs + (began && hastens ? Math.max(HASTE_WAIT_MS, waitMs) : waitMs)) {
            return;
        }
        if (!began) {
            if (tries == TRIES) {
                fail(notReady.orElseGet(() -> new IllegalStateException(
                        "vehicle " + vehicle + " does not answer when it is to be sent a " + kind.words())));
            } else {
                announce(nowMs);
            }
        } else if (asked == to - 1 && tries == LAST_TRIES) {
            succeed(); // it has the last item or nothing comes through; reading back finds out
        } else if (nowMs - progressMs > SILENCE_MS) {
            again(stalled(), nowMs);
        } else {
            lost += tries == 0 ? NEW_PART * (1 - lost) : 0;
            hastens = false;
            sendFrom(asked, Math.min(MOST_PUSHED, 1 + tries));
            tries++;
            sentMs = nowMs;
        }
    }

    private String stalled() {
        return "it asked for " + (asked - from + 1) + " of " + (to - from) + " items, and for no more"
                + unexpected.map(answer -> "; " + answer).orElse("");
    }

    @SuppressWarnings("deprecation") // ArduPilot still asks by the older message
    @Override
    public void take(Object message, long nowMs) {
        if (isOver()) {
            return;
        }
        if (message instanceof MissionRequestInt request && isOurs(request.missionType())) {
            wanted(request.seq(), nowMs);
        } else if (message instanceof MissionRequest request && isOurs(request.missionType())) {
            wanted(request.seq(), nowMs);
        } else if (message instanceof MissionAck ack && isOurs(ack.missionType())) {
            acknowledged(ack.type(), nowMs);
        }
    }

    private boolean isOurs(EnumValue<MavMissionType> type) {
        return type.entry() == kind.type();
    }

    private void wanted(int item, long nowMs) {
        if (item < from || item >= to) {
            return; // belongs to another transfer, or is wrong
        }
        if (item > asked) {
            if (tries == 0 || (asked < from && tries == 1)) {
                time.answered(nowMs - sentMs);
            }
            lost -= tries == 0 ? NEW_PART * lost : 0;
            progressMs = nowMs;
        } else if (item < asked && tries == 0) {
            return; // late, or doubled; it waits for a later one
        }
        hastens &= item > asked;
        asked = item; // lower, where the announcement came twice and it began again
        tries = 0;
        sentMs = nowMs;
        if (hastens) {
            int first = Math.max(item, sent + 1);
            sendFrom(first, item + AHEAD - first);
        } else {
            sendFrom(item, ahead());
        }
    }

    private void acknowledged(EnumValue<MavMissionResult> result, long nowMs) {
        MavMissionResult what = result.entry();
        boolean allSent = sent == to - 1;
        if (what == MavMissionResult.MAV_MISSION_ACCEPTED) {
            if (allSent) { // otherwise of an earlier transfer
                taken = true;
                succeed();
            }
        } else if (what == MavMissionResult.MAV_MISSION_INVALID_SEQUENCE) {
            unexpected = Optional.of(MissionWords.of(result)); // it says which one it waits for, or the round ends
            hastens = false;
        } else if (what == MavMissionResult.MAV_MISSION_ERROR && allSent) {
            succeed(); // the last item came to it twice: it had ended; reading back finds out
        } else if (what == MavMissionResult.MAV_MISSION_OPERATION_CANCELLED
                || (what == MavMissionResult.MAV_MISSION_ERROR && asked >= from)) {
            again(MissionWords.of(result), nowMs);
        } else {
            ListRefusedException refusal = new ListRefusedException(
                    "vehicle " + vehicle + " refuses the " + kind.words() + " of " + items.size() + " items" + where()
                            + ": ",
                    result);
            notReady = Optional.of(refusal);
            if (what != MavMissionResult.MAV_MISSION_ERROR) { // after that one it may be ready soon
                fail(refusal);
            }
        }
    }

    /** Whether the vehicle has said that it has taken the last item, before which it takes those before that one. */
    boolean isTaken() {
        return taken;
    }

    /** The item that the vehicle refused, and its position; empty where it refused the list before the first item. */
    private String where() {
        if (asked < from) {
            return "";
        }
        MissionItem item = items.get(asked);
        return String.format(
                Locale.ROOT, " at item %d (%s at %.7f, %.7f)", asked, item.commandName(), item.latDeg(), item.lonDeg());
    }

    private void again(String why, long nowMs) {
        if (rounds == ROUNDS) {
            fail("vehicle " + vehicle + " could not be sent its " + kind.words() + ": " + why);
        } else {
            begin(nowMs);
        }
    }
}
