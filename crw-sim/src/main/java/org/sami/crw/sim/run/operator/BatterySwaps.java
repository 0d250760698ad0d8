package org.sami.crw.sim.run.operator;

import java.util.Collection;
import org.sami.crw.service.Geodesy;
import org.sami.crw.session.archive.FleetHistory;
import org.sami.crw.sim.fleet.SimulatedFleet;
import org.sami.crw.sim.hull.Quay;
import org.sami.spn.value.GeoPoint;

/**
 * Whether somebody at the quay is still busy with batteries, as a person there sees it and as boats tell it, over TCP too: a boat lies near
 * the quay and its charge is not that of a new battery yet. For one thread.
 */
final class BatterySwaps {
    /** A boat that has come no farther than from its berth to its place in the line has a new battery. */
    private static final double NEW_PERCENT = 99;

    /** After so long nobody swaps the battery of a boat that lies there: it was only launched. Long enough for one that wind and current move. */
    private static final long TIMEOUT_MILLIS = 60_000;

    private final FleetHistory boats;
    private final GeoPoint quay;

    /**
     * Looks after the boats of a quay.
     *
     * @param quay the middle of the line in which they lie
     */
    BatterySwaps(FleetHistory boats, GeoPoint quay) {
        this.boats = boats;
        this.quay = quay;
    }

    /** Whether one of the boats is still to get its battery, so long after somebody was asked to see to them. */
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
