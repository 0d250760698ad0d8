package org.sami.crw.proxy.tcp;

import java.net.InetSocketAddress;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.ServiceLoader;
import org.sami.crw.fleet.RobotKind;
import org.sami.crw.proxy.gateway.BoatGateway;
import org.sami.crw.proxy.gateway.GatewayMaker;
import org.sami.spn.value.GeoArea;

/** The gateways of one base, each begun when an address needs it first. For the base's thread. */
final class Gateways {
    private final Map<GatewayMaker, BoatGateway> begun = new LinkedHashMap<>();
    private Optional<GeoArea> within = Optional.empty();
    private List<GeoArea> avoid = List.of();
    private RobotKind robots = RobotKind.BOAT;
    private Optional<Iterable<GatewayMaker>> makers = Optional.empty(); // of this program, once one was needed

    /** The gateway to an address; empty where the boat there speaks the link itself. */
    Optional<BoatGateway> to(InetSocketAddress address) {
        if (!VehicleAddress.isOne(address.getHostString())) {
            return Optional.empty();
        }
        if (makers.isEmpty()) {
            makers = Optional.of(ServiceLoader.load(GatewayMaker.class));
        }
        for (GatewayMaker maker : makers.get()) {
            if (address.getHostString().startsWith(maker.prefix())) {
                return Optional.of(gateway(maker));
            }
        }
        return Optional.empty();
    }

    /** One that could not begin is tried again for the next link. */
    private BoatGateway gateway(GatewayMaker maker) {
        try {
            return begun.computeIfAbsent(maker, this::begin);
        } catch (IllegalStateException e) {
            return new UnusableGateway(String.valueOf(e.getMessage()));
        }
    }

    private BoatGateway begin(GatewayMaker maker) {
        BoatGateway gateway = maker.begin();
        gateway.keepTo(within, avoid, robots);
        return gateway;
    }

    /** The area in which boats may go, for those that are begun and those that will be. */
    void keepTo(Optional<GeoArea> stayIn, List<GeoArea> keepOut, RobotKind whom) {
        robots = whom;
        within = stayIn;
        avoid = List.copyOf(keepOut);
        begun.values().forEach(gateway -> gateway.keepTo(within, avoid, robots));
    }

    /** Ends all that were begun. */
    void close() {
        begun.values().forEach(BoatGateway::close);
        begun.clear();
    }
}
