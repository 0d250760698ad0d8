package org.sami.crw.proxy;

import java.util.ArrayList;
import java.util.Collection;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.sami.boat.link.BoatMode;
import org.sami.crw.proxy.command.BoatCommand;
import org.sami.crw.service.Geodesy;
import org.sami.spn.value.GeoPoint;

/**
 * Finds boats that wait because another boat lies at their next waypoint: a boat that gives way to one that does not move waits until somebody moves
 * it. An aircraft lies there only at the waypoint's height, and one that climbs or sinks on the spot does not wait. For the thread that drives the proxies.
 */
public final class TakenWaypoints {
    /** So many looks, a second apart, a boat waits before it is named: many make room by then. */
    private static final int PATIENCE = 8;

    private static final double STILL_MPS = 0.3;
    private static final double AT_M = 5; // two boats that lie so near to one another are as near as they come
    private static final double WAITS_WITHIN_M = 15;
    private static final double HEIGHT_M = 3; // less than the layers in which aircraft fly are apart

    private final Map<String, Waits> waiting = new HashMap<>();

    /** How often in all a boat was seen to wait on its way to a point. */
    private record Waits(GeoPoint target, int looks) {}

    /**
     * A boat that waits.
     *
     * @param by the boat that lies at its next waypoint
     * @param mission whose path the boat follows
     */
    public record Taken(String boat, String by, long mission) {
        /** The same in words. */
        public String words() {
            return boat + " waits: " + by + " lies at its next waypoint";
        }
    }

    /** Looks at all boats; to be called once a second. Names each boat that waits once for each waypoint. */
    public List<Taken> look(Collection<BoatProxy> boats) {
        List<Taken> taken = new ArrayList<>();
        for (BoatProxy boat : boats) {
            Optional<GeoPoint> target = boat.traffic().target();
            if (target.isEmpty()) {
                waiting.remove(boat.boatId());
                continue;
            }
            Waits before = waiting.get(boat.boatId());
            int looks = before != null && before.target.equals(target.get()) ? before.looks : 0;
            Optional<String> by =
                    isWaiting(boat, target.get()) ? whoLiesAt(target.get(), boat, boats) : Optional.empty();
            if (by.isPresent()) {
                looks++;
                waiting.put(boat.boatId(), new Waits(target.get(), looks));
            }
            if (by.isPresent() && looks == PATIENCE) {
                long mission =
                        boat.commands().current().map(BoatCommand::mission).orElse(0L);
                taken.add(new Taken(boat.boatId(), by.get(), mission));
            }
        }
        return taken;
    }

    private static boolean isWaiting(BoatProxy boat, GeoPoint target) {
        return isAtHeight(boat, target)
                && boat.traffic()
                        .sighting()
                        .filter(at ->
                                at.mode() == BoatMode.PATH && isStill(at) && distanceM(at, target) < WAITS_WITHIN_M)
                        .isPresent();
    }

    private static Optional<String> whoLiesAt(GeoPoint target, BoatProxy boat, Collection<BoatProxy> boats) {
        return boats.stream()
                .filter(other -> other != boat
                        && isAtHeight(other, target)
                        && other.traffic()
                                .sighting()
                                .filter(at -> isStill(at) && distanceM(at, target) < AT_M)
                                .isPresent())
                .map(BoatProxy::boatId)
                .findFirst();
    }

    private static boolean isAtHeight(BoatProxy boat, GeoPoint point) {
        return !boat.isFlying()
                || boat.status()
                        .pose()
                        .filter(pose -> Math.abs(pose.position().altM() - point.altM()) >= HEIGHT_M)
                        .isEmpty();
    }

    private static boolean isStill(Sighting at) {
        return Math.abs(at.speedMps()) < STILL_MPS;
    }

    private static double distanceM(Sighting at, GeoPoint point) {
        return Geodesy.distanceM(GeoPoint.of(at.latDeg(), at.lonDeg()), point);
    }
}
