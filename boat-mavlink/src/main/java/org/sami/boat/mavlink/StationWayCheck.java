package org.sami.boat.mavlink;

import java.util.Optional;
import org.sami.boat.link.Waypoint;
import org.sami.boat.server.vehicle.LocalFrame;

/** Says why a boat may not go where a ground station sends it: too far away, or out of its fence. Looks only. For the boat's thread. */
final class StationWayCheck {
    private static final double FARTHEST_M = 20_000;
    private static final double KM = 1_000;

    private final String name;
    private final BoatClient boat;
    private final BoatFence fence;

    StationWayCheck(String name, BoatClient boat, BoatFence fence) {
        this.name = name;
        this.boat = boat;
        this.fence = fence;
    }

    private Optional<Position> here(long nowMs) {
        return boat.telemetry(nowMs).map(at -> new Position(at.latDeg(), at.lonDeg()));
    }

    /** Why it may not go to a place; empty where it may. */
    Optional<String> toPlace(Position place, long nowMs) {
        return here(nowMs)
                .map(here -> tooFar(here, place, "it").or(() -> outside(here, place, "the place")))
                .orElse(Optional.of(lostWords()));
    }

    /** Why it may not go along the part of a mission that is ahead; empty where it may. */
    Optional<String> along(MissionPath ahead, long nowMs) {
        Optional<Position> start = here(nowMs);
        if (start.isEmpty()) {
            return Optional.of(lostWords());
        }
        Position from = start.get();
        for (int i = 0; i < ahead.waypoints().size(); i++) {
            Waypoint next = ahead.waypoints().get(i);
            Position to = new Position(next.latDeg(), next.lonDeg());
            String words = "item " + ahead.itemOf(i);
            Position at = from;
            Optional<String> why = tooFar(start.get(), to, words).or(() -> outside(at, to, words));
            if (why.isPresent()) {
                return why;
            }
            from = to;
        }
        return Optional.empty();
    }

    /** Why it may not return; empty where it may, also where it does not know where it is, as a return is then the boat's own matter. */
    Optional<String> toHome(Waypoint home, long nowMs) {
        Position to = new Position(home.latDeg(), home.lonDeg());
        return outside(here(nowMs).orElse(to), to, "home");
    }

    /** Why it may not be steered by hand; empty where it may. */
    Optional<String> byHand() {
        return fence.isBreached()
                ? Optional.of(name + " is outside of its fence: send it to a place inside, or remove the fence")
                : Optional.empty();
    }

    private static Optional<String> tooFar(Position here, Position to, String words) {
        double metres = new LocalFrame(here.latDeg(), here.lonDeg()).distanceM(to.latDeg(), to.lonDeg());
        return metres > FARTHEST_M
                ? Optional.of(words + " is " + Math.round(metres / KM) + " km away")
                : Optional.empty();
    }

    private Optional<String> outside(Position from, Position to, String words) {
        if (!fence.fence().isInside(to)) {
            return Optional.of(words + " is outside of the fence");
        }
        return fence.fence().leadsOut(from, to)
                ? Optional.of("the way to " + words + " leads outside of the fence")
                : Optional.empty();
    }

    private String lostWords() {
        return name + " does not know where it is";
    }
}
