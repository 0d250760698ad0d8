package org.sami.boat.mavlink;

import java.util.List;
import java.util.Optional;
import org.sami.boat.link.SteadyClock;
import org.sami.mavlink.mission.HeldKind;
import org.sami.mavlink.mission.MissionItem;
import org.sami.mavlink.onboard.ListKeeper;
import org.sami.mavlink.onboard.OnboardLink;
import org.sami.mavlink.vehicle.TextSeverity;
import org.sami.mavlink.vehicle.VehicleId;

/** Takes the missions and fences that ground stations send a boat, or says why not. For the boat's thread. */
final class StationLists implements ListKeeper {
    private final String name;
    private final CommandingStation command;
    private final BoatVehicle vehicle;
    private final BoatFence fence;
    private final FenceGuard guard;
    private final OnboardLink link;
    private final SteadyClock clock;

    StationLists(
            String name,
            CommandingStation command,
            BoatVehicle vehicle,
            BoatFence fence,
            FenceGuard guard,
            OnboardLink link,
            SteadyClock clock) {
        this.name = name;
        this.command = command;
        this.vehicle = vehicle;
        this.fence = fence;
        this.guard = guard;
        this.link = link;
        this.clock = clock;
    }

    @Override
    public Optional<Refusal> whyNoList(VehicleId station, HeldKind kind, int items) {
        if (kind == HeldKind.RALLY) {
            return refused(Refusal.UNSUPPORTED, name + " keeps no rally points: it returns to its home");
        }
        Optional<String> why = command.whyNot(station, clock.getAsLong());
        if (why.isPresent()) {
            return refused(Refusal.DENIED, why.get());
        }
        return kind == HeldKind.FENCE && items > StationFenceItems.MOST
                ? refused(Refusal.NO_SPACE, "a fence of " + name + " has at most " + StationFenceItems.MOST + " items")
                : Optional.empty();
    }

    private Optional<Refusal> refused(Refusal refusal, String why) {
        link.say(TextSeverity.WARNING, why);
        return Optional.of(refusal);
    }

    @Override
    public Optional<Refusal> whyNot(HeldKind kind, MissionItem item) {
        boolean isFence = kind == HeldKind.FENCE;
        boolean isKnown = isFence ? StationFenceItems.isKnown(item) : MissionPath.isKnown(item);
        Optional<String> why = isFence ? StationFenceItems.whyNot(item) : MissionPath.whyNot(item);
        if (why.isPresent()) {
            return refused(isKnown ? Refusal.INVALID : Refusal.UNSUPPORTED, why.get());
        }
        return MissionPath.isKnownFrame(item)
                ? Optional.empty()
                : refused(
                        Refusal.UNSUPPORTED_FRAME,
                        kind.words() + " item " + item.number() + " has the unknown frame " + item.frame());
    }

    @Override
    public void unreadable(HeldKind kind, String why) {
        link.say(TextSeverity.WARNING, kind.words() + " refused: " + why);
    }

    @Override
    public Optional<Refusal> whyNotWhole(HeldKind kind, List<MissionItem> items) {
        return kind == HeldKind.FENCE
                ? StationFenceItems.whyNotWhole(items).flatMap(why -> refused(Refusal.INVALID, why))
                : Optional.empty();
    }

    @Override
    public void changed(HeldKind kind, List<MissionItem> items) {
        long nowMs = clock.getAsLong();
        if (kind == HeldKind.MISSION) {
            List<MissionItem> own = MissionPath.withHome(items, vehicle.home());
            link.hold(own);
            vehicle.missionChanged(own, nowMs).ifPresent(why -> link.say(TextSeverity.NOTICE, why));
        } else if (kind == HeldKind.FENCE) {
            fence.replace(items);
            if (StationFenceItems.hasReturnPoint(items)) {
                link.say(
                        TextSeverity.NOTICE,
                        "the fence's return point is not used: outside, " + name + " keeps its place");
            }
            guard.replaced(nowMs);
        }
    }
}
