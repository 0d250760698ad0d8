package org.sami.crw.proxy.tcp;

import java.net.InetSocketAddress;
import java.util.List;
import java.util.Optional;
import org.sami.crw.fleet.RobotKind;
import org.sami.crw.proxy.gateway.BoatGateway;
import org.sami.crw.proxy.gateway.GatewayLink;
import org.sami.spn.value.GeoArea;

/** Stands for a gateway that could not begin: each link ends at once, for that reason. */
final class UnusableGateway implements BoatGateway {
    private final String why;

    UnusableGateway(String why) {
        this.why = why;
    }

    @Override
    public GatewayLink connect(InetSocketAddress address, GatewayLink.Listener listener) {
        listener.closed(why);
        return new GatewayLink() {
            @Override
            public void send(byte[] frame) {
                // nobody hears it
            }

            @Override
            public void close() {
                // it never was open
            }
        };
    }

    @Override
    public void keepTo(Optional<GeoArea> within, List<GeoArea> avoid, RobotKind robots) {
        // there are no vehicles
    }

    @Override
    public void close() {
        // there is nothing to end
    }
}
