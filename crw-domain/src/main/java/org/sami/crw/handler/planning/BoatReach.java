package org.sami.crw.handler.planning;

import java.util.Optional;
import java.util.OptionalDouble;
import org.sami.boat.link.BoatCapabilities;
import org.sami.crw.handler.motion.SpeedChoice;
import org.sami.crw.proxy.BoatProxy;
import org.sami.crw.proxy.ProxyRegistry;
import org.sami.crw.service.reach.Charge;
import org.sami.spn.protocol.Activation;
import org.sami.spn.value.GeoPoint;

/** How far and how fast each boat gets, what it can do, and where it returns to, as it has reported: what work is divided by. For the fleet's thread. */
public final class BoatReach {
    private final ProxyRegistry boats;

    /** Of the boats that are known. */
    public BoatReach(ProxyRegistry boats) {
        this.boats = boats;
    }

    /** How far a boat's charge is sure to take it, in metres; empty for one that has not reported a charge. */
    OptionalDouble rangeM(String boat) {
        return boats.find(boat).flatMap(BoatProxy::charge).stream()
                .mapToDouble(Charge::sureM)
                .findFirst();
    }

    /** The same on paths of an activation, whose speed follows from its markup Optimize. */
    OptionalDouble rangeM(String boat, Activation activation) {
        return boats.find(boat).flatMap(known -> known.charge(SpeedChoice.mps(activation, known))).stream()
                .mapToDouble(Charge::sureM)
                .findFirst();
    }

    /** A boat's speed on paths that name none, in m/s; empty for an unknown boat. */
    OptionalDouble cruiseMps(String boat) {
        return boats.find(boat).stream().mapToDouble(BoatProxy::cruiseSpeedMps).findFirst();
    }

    /** The radius of a boat's narrowest turn, in metres; 0 for one that turns on the spot or has not said it. */
    double turningRadiusM(String boat) {
        return boats.find(boat).map(BoatProxy::turningRadiusM).orElse(0.0);
    }

    /** What a boat cannot do and what it measures, where it says so. */
    BoatCapabilities capabilities(String boat) {
        return boats.find(boat).map(BoatProxy::capabilities).orElse(BoatCapabilities.UNKNOWN);
    }

    /** Whether it flies, so that work on the water is not for it. */
    boolean isFlying(String robot) {
        return boats.find(robot).map(BoatProxy::isFlying).orElse(false);
    }

    /** Where a boat returns to; empty for one that has not said. */
    Optional<GeoPoint> home(String boat) {
        return boats.find(boat).flatMap(BoatProxy::home);
    }
}
