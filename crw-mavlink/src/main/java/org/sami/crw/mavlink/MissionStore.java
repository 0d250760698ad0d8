package org.sami.crw.mavlink;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Executor;
import java.util.function.BiConsumer;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import org.sami.mavlink.base.MavlinkBase;
import org.sami.mavlink.mission.HeldKind;
import org.sami.mavlink.mission.ListRefusedException;
import org.sami.mavlink.vehicle.VehicleId;

/** The mission that a vehicle holds: brings a list there and knows whether it is there, read back. For the gateway's thread. */
final class MissionStore {
    /** Why a list is not brought to a vehicle that drives along something else. */
    static final String ANOTHER = "it drives along another mission than it was given";

    /** Items that a network brings and reads back well before a base gives up waiting for the boat's answer, after 20 s. */
    private static final int MOST_OFFERED = 2_500;

    private static final int MOST_TRIES = 3;
    private static final int MOST_READS = 30; // a vehicle refuses them while another station sends it a mission
    private static final long READ_AGAIN_MS = 1_000;

    private final MavlinkBase base;
    private final VehicleId id;
    private final Executor thread;
    private final BooleanSupplier drives;
    private final BooleanSupplier isOnNetwork;
    private final MissionParts parts;
    private Optional<DrivenList> held = Optional.empty(); // read back equal
    private Optional<DrivenList> coming = Optional.empty();
    private int tries;
    private final List<Consumer<Optional<String>>> waiting = new ArrayList<>(); // for what comes
    private final Consumer<DrivenList> replaced;
    private int doubts; // how often it may still be read whether the vehicle holds what it was read to hold
    private boolean isReading;
    private int tooMany = Integer.MAX_VALUE; // items, for which the vehicle has said that it has no room
    private long readAgainMs;

    /**
     * Nothing is known to be held.
     *
     * @param drives whether the vehicle drives along its mission now
     * @param isOnNetwork whether it is reached by networks only, which bring a long list in seconds
     * @param further called when the vehicle holds a further part of a list, with the item at which it had to stop before
     * @param replaced called when the vehicle is read to hold another mission than the list that it held
     * @param alarm receives faults, in words for the operator
     */
    MissionStore(
            MavlinkBase base,
            VehicleId id,
            Executor thread,
            BooleanSupplier drives,
            BooleanSupplier isOnNetwork,
            BiConsumer<DrivenList, Integer> further,
            Consumer<DrivenList> replaced,
            Consumer<String> alarm) {
        this.base = base;
        this.id = id;
        this.thread = thread;
        this.drives = drives;
        this.isOnNetwork = isOnNetwork;
        this.replaced = replaced;
        parts = new MissionParts(base, id, thread, list -> holds(Optional.of(list)), further, alarm);
    }

    /** Sends the next part of a long list that the vehicle holds, where it has left enough of it behind. To be called often. */
    void tick(long atMs) {
        held.ifPresent(list -> parts.tick(list, atMs));
        if (doubts > 0 && atMs >= readAgainMs && !isReading && !isMoving()) {
            readAgainMs = atMs + READ_AGAIN_MS;
            held.ifPresentOrElse(this::compare, () -> doubts = 0);
        }
    }

    /** Whether a mission is on its way to the vehicle; it is read back at the end of that. */
    boolean isMoving() {
        return coming.isPresent() || parts.isSending();
    }

    /** The vehicle says that its mission is another: it is read and compared, unless that is about to be done in any case. */
    void doubt() {
        if (!isMoving()) {
            doubts = MOST_READS;
        }
    }

    private void compare(DrivenList list) {
        doubts--;
        isReading = true;
        Results.when(
                base.held(id, HeldKind.MISSION),
                thread,
                there -> {
                    isReading = false;
                    doubts = 0;
                    if (holds(Optional.of(list)) && !isMoving() && !list.recognizes(there)) {
                        replaced.accept(list);
                    }
                },
                why -> isReading = false);
    }

    /** Whether the vehicle holds this list. */
    boolean holds(Optional<DrivenList> list) {
        return list.isPresent() && held.isPresent() && held.get() == list.get();
    }

    /** What is held is not known any longer. */
    void forget() {
        held = Optional.empty();
    }

    /** The autopilot has started again: what it holds is not known any longer, nor for how much it has room. */
    void restarted() {
        forget();
        tooMany = Integer.MAX_VALUE;
    }

    /** Nothing more is sent, and nobody is told of what was to come. */
    void giveUp() {
        forget();
        coming = Optional.empty();
        waiting.clear();
        doubts = 0;
    }

    /** Begins to bring a list to the vehicle in place of the one that it holds. */
    void put(DrivenList list) {
        whenReadBack(list, why -> {});
    }

    /**
     * Calls back once the vehicle has been read to hold the list, or with the reason why it does not. It is read in any case, as somebody else may have replaced
     * what it held, and sent only where it is not there.
     */
    void whenReadBack(DrivenList list, Consumer<Optional<String>> then) {
        if (coming.isPresent() && coming.get() != list) {
            end(Optional.of(VehiclePilot.VOID));
        }
        waiting.add(then);
        if (coming.isEmpty()) {
            coming = Optional.of(list);
            tries = 0;
            look(list);
        }
    }

    /** What is there already is not sent again. */
    private void look(DrivenList list) {
        Results.when(
                base.held(id, HeldKind.MISSION),
                thread,
                there -> {
                    if (isComing(list) && list.recognizes(there)) {
                        arrived(list);
                    } else if (isComing(list) && drives.getAsBoolean()) {
                        held = Optional.empty();
                        end(Optional.of(ANOTHER)); // nothing is changed under a vehicle that drives along it
                    } else {
                        send(list);
                    }
                },
                why -> {
                    if (isComing(list) && (holds(coming) || drives.getAsBoolean())) { // maybe along this list
                        end(Optional.of(why));
                    } else {
                        send(list);
                    }
                });
    }

    /** All of it where the vehicle has room for that, and says so at once; else its part. */
    private void send(DrivenList list) {
        if (isComing(list)) {
            held = Optional.empty();
            MissionWindow part = list.window();
            boolean isOffered = isOffered(list.whole().size());
            list.window(isOffered ? list.whole() : part); // this one, whatever an earlier base has brought there
            Results.whenOrFailed(
                    base.replace(id, HeldKind.MISSION, list.window().items()),
                    thread,
                    there -> {
                        if (isComing(list) && list.recognizes(there)) {
                            arrived(list);
                        } else {
                            again(list, "vehicle " + id + " holds another mission than was sent");
                        }
                    },
                    failed -> {
                        boolean isFull = failed instanceof ListRefusedException refused && refused.isOutOfSpace();
                        if (isOffered && isFull) {
                            tooMany = list.whole().size();
                            list.window(part.size() < tooMany ? part : list.windowFrom(list.next()));
                            send(list);
                        } else {
                            list.window(part);
                            again(list, Results.words(failed));
                        }
                    });
        }
    }

    private boolean isOffered(int items) {
        return items > MissionWindow.MOST_WHOLE
                && items <= MOST_OFFERED
                && items < tooMany
                && isOnNetwork.getAsBoolean();
    }

    private void again(DrivenList list, String why) {
        if (isComing(list) && ++tries == MOST_TRIES) {
            end(Optional.of(why));
        } else {
            send(list);
        }
    }

    private boolean isComing(DrivenList list) {
        return coming.isPresent() && coming.get() == list;
    }

    private void arrived(DrivenList list) {
        held = Optional.of(list);
        end(Optional.empty());
    }

    private void end(Optional<String> why) {
        coming = Optional.empty();
        List<Consumer<Optional<String>>> told = List.copyOf(waiting);
        waiting.clear();
        told.forEach(each -> each.accept(why));
    }
}
