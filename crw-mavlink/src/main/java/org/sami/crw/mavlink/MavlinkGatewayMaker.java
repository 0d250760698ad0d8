package org.sami.crw.mavlink;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;
import org.sami.boat.link.SteadyClock;
import org.sami.crw.proxy.gateway.BoatGateway;
import org.sami.crw.proxy.gateway.GatewayMaker;
import org.sami.crw.proxy.key.BaseKeys;
import org.sami.crw.proxy.tcp.BaseProtection;
import org.sami.mavlink.address.MavlinkAddress;
import org.sami.mavlink.link.SigningKey;

/** Makes gateways to vehicles that speak MAVLink; found by {@link java.util.ServiceLoader}. Safe for use by several threads. */
public final class MavlinkGatewayMaker implements GatewayMaker {

    /** For {@link java.util.ServiceLoader}. */
    public MavlinkGatewayMaker() {}

    @Override
    public String prefix() {
        return MavlinkAddress.PREFIX;
    }

    /** A gateway that signs with the key of the fleet, where this base has one ({@code crw keys fleet}), also after it was replaced. */
    @Override
    public BoatGateway begin() {
        return new MavlinkGateway(
                SteadyClock.ofThisMachine(), VehicleFiles.ofThisUser(), MavlinkGatewayMaker::fleetKey);
    }

    private static Optional<SigningKey> fleetKey() {
        Path folder = BaseProtection.ofThisProcess().keysFolder();
        try {
            return new BaseKeys(folder).fleetKey().map(SigningKey::new);
        } catch (IOException | IllegalArgumentException e) {
            throw new IllegalStateException(
                    "the key of the fleet in " + folder + " cannot be read: " + e.getMessage(), e);
        }
    }
}
