package org.sami.crw.proxy.gateway;

/** Makes the gateways of one protocol. Programs have those that {@link java.util.ServiceLoader} finds. */
public interface GatewayMaker {

    /** What the addresses of this protocol begin with. */
    String prefix();

    /** A gateway for one base. */
    BoatGateway begin();
}
