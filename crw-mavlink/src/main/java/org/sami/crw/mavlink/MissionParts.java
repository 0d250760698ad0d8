package org.sami.crw.mavlink;

import java.util.List;
import java.util.concurrent.Executor;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import java.util.function.Predicate;
import org.sami.mavlink.base.MavlinkBase;
import org.sami.mavlink.mission.HeldKind;
import org.sami.mavlink.vehicle.VehicleId;

/**
 * Sends the next part of a long list to the vehicle that drives along it ({@link MissionWindow}): first the items behind the stop, and once the vehicle has taken
 * them all, the item that takes the place of the stop; then all is read back. Both come at one {@link ChangeMoment moment} that costs the vehicle least, as it
 * begins its leg again with each. A part that could not be sent is tried again, which the operator hears of, and the vehicle stops there at worst. For the
 * gateway's thread.
 */
final class MissionParts {
    private static final long AGAIN_MS = 1_000;

    private final MavlinkBase base;
    private final VehicleId id;
    private final Executor thread;
    private final Predicate<DrivenList> isHeld;
    private final BiConsumer<DrivenList, Integer> further;
    private final Consumer<String> alarm;
    private final ChangeMoment moment = new ChangeMoment();
    private String lastFault = "";
    private boolean sending;
    private long notBeforeMs;

    /**
     * Nothing is sent yet.
     *
     * @param isHeld whether the vehicle holds a list, as far as is known; what is no longer held is not sent any further
     * @param further called when the vehicle holds a further part of a list, with the item of the list at which it had to stop before
     * @param alarm receives faults, in words for the operator
     */
    MissionParts(
            MavlinkBase base,
            VehicleId id,
            Executor thread,
            Predicate<DrivenList> isHeld,
            BiConsumer<DrivenList, Integer> further,
            Consumer<String> alarm) {
        this.base = base;
        this.id = id;
        this.thread = thread;
        this.isHeld = isHeld;
        this.further = further;
        this.alarm = alarm;
    }

    /** Begins to send the next part of a list where the vehicle has left enough of the list behind. To be called often. */
    void tick(DrivenList list, long atMs) {
        if (sending || atMs < notBeforeMs) {
            return;
        }
        list.nextWindow()
                .filter(next -> moment.isNow(list.waypoints(), list.next(), list.waypointsUpTo(next.stop()), atMs))
                .ifPresent(next -> {
                    sending = true;
                    notBeforeMs = atMs + AGAIN_MS;
                    list.window(next); // what lies behind the vehicle is given up before it is overwritten
                    list.replacesStop();
                    send(list, next);
                });
    }

    /** Whether a part is on its way; what the vehicle holds is read back at its end. */
    boolean isSending() {
        return sending;
    }

    private void opened(DrivenList list, MissionWindow next) {
        sending = false;
        lastFault = "";
        list.window(next.stoppingAtItsEnd());
        further.accept(list, next.stop());
    }

    /** Only what differs from what the vehicle holds is sent. Where the list has been given another part meanwhile, that one counts. */
    private void send(DrivenList list, MissionWindow next) {
        Results.when(
                base.replaceInSteps(
                        id,
                        HeldKind.MISSION,
                        List.of(next.items(), next.stoppingAtItsEnd().items())),
                thread,
                there -> {
                    if (isHeld.test(list) && list.window() == next) {
                        opened(list, next);
                    } else {
                        sending = false;
                    }
                },
                this::failed);
    }

    /** Says it once for each reason. */
    private void failed(String why) {
        sending = false;
        if (!why.equals(lastFault)) {
            lastFault = why;
            alarm.accept("vehicle " + id + " has not taken the next part of its path, and waits where its part ends: "
                    + why);
        }
    }
}
