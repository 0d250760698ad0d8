package org.sami.crw.proxy.tcp;

import java.net.InetSocketAddress;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicBoolean;
import org.sami.boat.link.security.Fingerprint;
import org.sami.crw.proxy.gateway.BoatGateway;
import org.sami.crw.proxy.gateway.GatewayLink;
import org.sami.crw.proxy.gateway.LinkStatus;
import org.sami.spn.protocol.Priority;

/** A connection to a vehicle for which a gateway in this process speaks the boat link: frames are handed over in memory, and nobody else can reach it. */
final class GatewayConnection implements BoatConnection {
    private final BoatGateway gateway;
    private final InetSocketAddress address;
    private final Owner owner;
    private final AtomicBoolean closed = new AtomicBoolean();
    private volatile Optional<GatewayLink> link = Optional.empty(); // once it was begun

    GatewayConnection(BoatGateway gateway, InetSocketAddress address, Owner owner) {
        this.gateway = gateway;
        this.address = address;
        this.owner = owner;
    }

    @Override
    public void start() {
        link = Optional.of(gateway.connect(address, new ToOwner()));
        if (closed.get()) { // meanwhile
            link.get().close();
        }
    }

    @Override
    public void send(byte[] frame) {
        link.ifPresent(begun -> begun.send(frame));
    }

    @Override
    public Optional<Fingerprint> peer() {
        return Optional.empty();
    }

    @Override
    public List<LinkStatus> linkStatuses() {
        return link.map(GatewayLink::linkStatuses).orElse(List.of());
    }

    @Override
    public long takeLeftOut() {
        return 0;
    }

    @Override
    public void close(String why) {
        if (closed.compareAndSet(false, true)) {
            link.ifPresent(GatewayLink::close);
            owner.closed(this, why);
        }
    }

    @Override
    public void join(long millis) {
        // it has no threads of its own
    }

    private static void taken() {
        // a gateway needs no limit: it sends no more than a vehicle reports
    }

    private final class ToOwner implements GatewayLink.Listener {
        @Override
        public void opened() {
            owner.opened(GatewayConnection.this);
        }

        @Override
        public void arrived(byte[] frame) {
            owner.arrived(GatewayConnection.this, frame, GatewayConnection::taken);
        }

        @Override
        public void said(Priority priority, String text) {
            owner.said(priority, text);
        }

        @Override
        public void closed(String why) {
            close(why);
        }

        @Override
        public void refused(String why) {
            if (closed.compareAndSet(false, true)) {
                link.ifPresent(GatewayLink::close);
                owner.refused(GatewayConnection.this, why);
            }
        }

        @Override
        public void found(InetSocketAddress boat) {
            owner.found(boat);
        }
    }
}
