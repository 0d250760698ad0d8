package org.sami.crw.proxy.tcp;

import org.sami.crw.proxy.gateway.BoatGateway;
import org.sami.crw.proxy.gateway.GatewayMaker;

/** Makes no gateway, as one whose key cannot be read; found by {@link java.util.ServiceLoader} in the tests of this module. */
public final class KeylessGatewayMaker implements GatewayMaker {
    static final String WHY = "the key of the fleet in /keys cannot be read: it is damaged";

    /** For {@link java.util.ServiceLoader}. */
    public KeylessGatewayMaker() {}

    @Override
    public String prefix() {
        return "mavlink:";
    }

    @Override
    public BoatGateway begin() {
        throw new IllegalStateException(WHY);
    }
}
