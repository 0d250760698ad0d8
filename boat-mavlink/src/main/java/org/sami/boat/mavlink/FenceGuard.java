package org.sami.boat.mavlink;

import java.util.Optional;
import org.sami.mavlink.vehicle.TextSeverity;

/** Has a boat that a ground station commands keep its place where it is outside of its fence, and says so. A base of ours is not bound by it. For the boat's thread. */
final class FenceGuard {
    private final String name;
    private final BoatClient boat;
    private final BoatFence fence;
    private final BoatVehicle vehicle;
    private final CommandingStation.Voice voice;
    private final Runnable changed;
    private boolean isStopped; // for the breach that lasts: orders that lead back in are carried out after it

    /**
     * A guard.
     *
     * @param changed is run when the boat has left the fence or is back
     */
    FenceGuard(
            String name,
            BoatClient boat,
            BoatFence fence,
            BoatVehicle vehicle,
            CommandingStation.Voice voice,
            Runnable changed) {
        this.name = name;
        this.boat = boat;
        this.fence = fence;
        this.vehicle = vehicle;
        this.voice = voice;
        this.changed = changed;
    }

    /** Looks where the boat is. */
    void tick(long nowMs) {
        if (look(nowMs)) {
            changed.run();
        }
    }

    /** Whether a breach begins or ends. */
    private boolean look(long nowMs) {
        Optional<Position> here = boat.telemetry(nowMs).map(at -> new Position(at.latDeg(), at.lonDeg()));
        boolean isChanged = fence.look(here, boat.otherCommander().isEmpty(), nowMs);
        boolean stops = fence.isBreached() && boat.commands() && !isStopped;
        isStopped = fence.isBreached() && boat.commands();
        boolean keepsPlace = stops && vehicle.keepPlace(nowMs);
        if (fence.isBreached() && (isChanged || keepsPlace)) {
            voice.say(
                    TextSeverity.CRITICAL,
                    name + " is outside of its fence" + (keepsPlace ? " and keeps its place" : ""));
        } else if (isChanged) {
            voice.say(
                    TextSeverity.NOTICE,
                    fence.isInForce() ? name + " is inside of its fence again" : name + " has no fence in force now");
        }
        return isChanged;
    }

    /** Another fence came. */
    void replaced(long nowMs) {
        vehicle.fenceChanged(nowMs).ifPresent(why -> voice.say(TextSeverity.WARNING, why));
        vehicle.whyNoReturn(nowMs)
                .ifPresent(why -> voice.say(TextSeverity.NOTICE, why + ": " + name + " is not sent home"));
        look(nowMs);
        changed.run();
    }
}
