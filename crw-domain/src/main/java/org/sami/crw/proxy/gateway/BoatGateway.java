package org.sami.crw.proxy.gateway;

import java.net.InetSocketAddress;

/** Reaches vehicles that do not speak the boat link, and speaks it for them in this process (docs/mavlink.md). Safe for use by several threads. */
public interface BoatGateway extends AutoCloseable {

    /**
     * Begins to reach the vehicle at an address; returns at once.
     *
     * @param address unresolved; its host and port are those of a {@code BoatAddress}
     */
    GatewayLink connect(InetSocketAddress address, GatewayLink.Listener listener);

    /** Ends all links without a call of their listeners. */
    @Override
    void close();
}
