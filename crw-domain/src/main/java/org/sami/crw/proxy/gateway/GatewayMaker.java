package org.sami.crw.proxy.gateway;

/** Makes the gateways of one protocol; found by {@link java.util.ServiceLoader}. Called on the thread of a base. */
public interface GatewayMaker {

    /** The prefix of this protocol's addresses, such as {@code mavlink:}. */
    String prefix();

    /**
     * A gateway for one base.
     *
     * @throws IllegalStateException if it cannot begin, for a reason in words that a user can act on
     */
    BoatGateway begin();
}
