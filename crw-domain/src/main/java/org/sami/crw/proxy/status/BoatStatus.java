package org.sami.crw.proxy.status;

import java.util.Optional;
import org.sami.boat.link.BoatMode;

/**
 * The latest that is known of a boat.
 *
 * @param bootId names the start of the boat's server; empty before the first link
 * @param pose empty before the first telemetry; old while the link is lost
 * @param battery empty before the first report
 * @param mode what the boat does; empty before the first telemetry
 */
public record BoatStatus(
        String boatId,
        LinkState link,
        String bootId,
        Optional<BoatPose> pose,
        Optional<BatteryState> battery,
        Optional<BoatMode> mode) {

    /** A boat of which nothing has been heard. */
    public static BoatStatus unknown(String boatId) {
        return new BoatStatus(boatId, LinkState.CONNECTING, "", Optional.empty(), Optional.empty(), Optional.empty());
    }

    /** The same with another link. */
    public BoatStatus with(LinkState newLink, String newBootId) {
        return new BoatStatus(boatId, newLink, newBootId, pose, battery, mode);
    }

    /** The same with what telemetry said. */
    public BoatStatus with(BoatPose newPose, Optional<BatteryState> newBattery, BoatMode newMode) {
        return new BoatStatus(boatId, link, bootId, Optional.of(newPose), newBattery, Optional.of(newMode));
    }

    /** The same with another battery. */
    public BoatStatus with(BatteryState newBattery) {
        return new BoatStatus(boatId, link, bootId, pose, Optional.of(newBattery), mode);
    }
}
