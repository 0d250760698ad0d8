package org.sami.crw.proxy.gateway;

import java.net.InetSocketAddress;
import java.util.List;
import java.util.Optional;
import org.sami.crw.fleet.RobotKind;
import org.sami.spn.value.GeoArea;

/** Reaches vehicles that do not speak the boat link, and speaks it for them in this process (docs/mavlink.md). Safe for use by several threads. */
public interface BoatGateway extends AutoCloseable {

    /**
     * Begins to reach the vehicle at an address; returns at once.
     *
     * @param address unresolved; its host and port are those of a {@code BoatAddress}
     */
    GatewayLink connect(InetSocketAddress address, GatewayLink.Listener listener);

    /**
     * The area in which boats of this base may go, now and from now on: vehicles with a fence of their own keep to it by themselves.
     *
     * @param within the area to stay in; empty without one
     * @param avoid areas that boats may not enter
     * @param robots whom the area binds: it is water where boats are, so copters keep to it only where all are copters
     */
    void keepTo(Optional<GeoArea> within, List<GeoArea> avoid, RobotKind robots);

    /** Ends all links without a call of their listeners. */
    @Override
    void close();
}
