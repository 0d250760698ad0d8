package org.sami.crw.sim.tcp;

import java.util.List;
import java.util.Optional;
import org.sami.boat.server.vehicle.LocalFrame;
import org.sami.crw.proxy.tcp.BoatAddress;
import org.sami.crw.report.LinkResult;
import org.sami.crw.sim.run.record.BoatState;
import org.sami.session.record.FleetHistory;

/** The boats of a session as a run's report has them. Safe for use by several threads. */
final class RunBoats {
    private final FleetHistory status;
    private final LocalFrame plane;

    /**
     * Boats of a run.
     *
     * @param plane around the area's centre
     */
    RunBoats(FleetHistory status, LocalFrame plane) {
        this.status = status;
        this.plane = plane;
    }

    /** The boats that have ever reported a position, by name, with their last state. */
    List<BoatState> all() {
        return status.boats().stream().map(this::state).toList();
    }

    /** One boat, if it has ever reported a position. */
    Optional<BoatState> find(String boat) {
        return status.boat(boat).map(this::state);
    }

    private BoatState state(FleetHistory.Boat boat) {
        double latDeg = boat.report().position().latDeg();
        double lonDeg = boat.report().position().lonDeg();
        return new BoatState(
                boat.id(),
                plane.eastM(latDeg, lonDeg),
                plane.northM(latDeg, lonDeg),
                latDeg,
                lonDeg,
                boat.report().speedMps(),
                boat.report().batteryPercent(),
                boat.distanceM(),
                boat.recharges(),
                boat.report().position().altM());
    }

    /** Addresses of other makers' vehicles name their kind of link themselves. */
    private static String way(String address) {
        return BoatAddress.isOnMavlink(address) ? address : ("tcp " + address).strip();
    }

    /** How a boat's link went. */
    LinkResult link(String boat) {
        FleetHistory.Link link = status.link(boat);
        return new LinkResult(
                way(link.address()),
                link.bootId(),
                link.lost(),
                link.reconnected(),
                LinkResult.Uploads.of(link.uploads()),
                link.why());
    }
}
