package org.sami.crw.sim.run.incident;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import org.sami.boat.server.vehicle.PlaneMath;
import org.sami.crw.sim.run.record.BoatState;

/**
 * Notices that a run cannot end because batteries are empty: some are, and no boat has come anywhere for long. Without it such a run would go on to its
 * limit, which is hours, and its row would not say why.
 */
final class EmptyBatteries {
    /** Longer than an alarm, a swap, or the drift of boats that wait for each other. */
    private static final long STILL_MILLIS = 1_800_000;

    /** More than a boat drifts that keeps a station, in metres. */
    private static final double MOVED_M = 15;

    private static final long PERIOD_MILLIS = 10_000;

    private final Map<String, BoatState> places =
            new HashMap<>(); // of each boat with charge when it last came somewhere
    private long movedMillis;
    private long lookedMillis = -PERIOD_MILLIS;

    /**
     * Why the run cannot end; empty while it can.
     *
     * @param isUnderWay whether a boat drives by itself, by its name: others may drift
     */
    Optional<String> look(long nowMillis, List<BoatState> boats, Predicate<String> isUnderWay) {
        for (BoatState boat : boats) {
            BoatState before = places.putIfAbsent(boat.id(), boat);
            if (before != null
                    && boat.batteryPercent() > 0
                    && isUnderWay.test(boat.id())
                    && PlaneMath.length(boat.eastM() - before.eastM(), boat.northM() - before.northM()) > MOVED_M) {
                places.put(boat.id(), boat);
                movedMillis = nowMillis;
            }
        }
        String empty = boats.stream()
                .filter(boat -> boat.batteryPercent() <= 0)
                .map(BoatState::id)
                .collect(Collectors.joining(", "));
        return empty.isEmpty() || nowMillis - movedMillis <= STILL_MILLIS
                ? Optional.empty()
                : Optional.of("empty battery: " + empty + ", and no other boat is under way for "
                        + STILL_MILLIS / 60_000 + " min");
    }

    /** Whether it is time to look again. */
    boolean isDue(long nowMillis) {
        boolean isDue = nowMillis - lookedMillis >= PERIOD_MILLIS;
        lookedMillis = isDue ? nowMillis : lookedMillis;
        return isDue;
    }
}
