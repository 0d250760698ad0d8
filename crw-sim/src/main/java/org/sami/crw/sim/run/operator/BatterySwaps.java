package org.sami.crw.sim.run.operator;

import java.util.Collection;
import org.sami.crw.service.Geodesy;
import org.sami.crw.sim.fleet.SimulatedFleet;
import org.sami.crw.sim.hull.Quay;
import org.sami.session.record.FleetHistory;
import org.sami.spn.value.GeoPoint;

/**
 * Whether a person at the quay is still changing batteries, judged from what boats report (also over TCP): a boat lies near the quay, and its charge
 * is not that of a new battery yet. For one thread.
 */
final class BatterySwaps {
    /** A boat that has driven no farther than from its berth to its place in the line already has a new battery. */
    private static final double NEW_PERCENT = 99;

    /**
     * After this time nobody changes the battery of a boat that lies there: it was only launched. Long enough for a boat that wind and current move.
     */
    private static final long TIMEOUT_MILLIS = 60_000;

    private final FleetHistory boats;
    private final GeoPoint quay;

    /**
     * Watches the boats of a quay.
     *
     * @param quay the middle of the line in which they lie
     */
    BatterySwaps(FleetHistory boats, GeoPoint quay) {
        this.boats = boats;
        this.quay = quay;
    }

    /** Whether a boat is still waiting for its battery, this long after the request. */
    boolean areUnderWay(Collection<String> some, long afterMillis) {
        return afterMillis < TIMEOUT_MILLIS && some.stream().anyMatch(this::waits);
    }

    private boolean waits(String boat) {
        double reachM = Quay.REACH_M + boats.boats().size() * SimulatedFleet.SPACING_M / 2;
        return boats.last(boat)
                .filter(told ->
                        told.batteryPercent() < NEW_PERCENT && Geodesy.distanceM(told.position(), quay) <= reachM)
                .isPresent();
    }
}
