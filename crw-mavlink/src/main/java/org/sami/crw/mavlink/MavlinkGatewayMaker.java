package org.sami.crw.mavlink;

import org.sami.boat.link.SteadyClock;
import org.sami.crw.proxy.gateway.BoatGateway;
import org.sami.crw.proxy.gateway.GatewayMaker;
import org.sami.mavlink.address.MavlinkAddress;

/** Makes gateways to vehicles that speak MAVLink; found by {@link java.util.ServiceLoader}. Safe for use by several threads. */
public final class MavlinkGatewayMaker implements GatewayMaker {

    /** For {@link java.util.ServiceLoader}. */
    public MavlinkGatewayMaker() {}

    @Override
    public String prefix() {
        return MavlinkAddress.PREFIX;
    }

    @Override
    public BoatGateway begin() {
        return new MavlinkGateway(SteadyClock.ofThisMachine(), VehicleFiles.ofThisUser());
    }
}
