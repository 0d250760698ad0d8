package org.sami.crw.sim.boat;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.UnaryOperator;
import org.sami.boat.link.Role;
import org.sami.boat.link.security.KeyRing;
import org.sami.boat.link.security.LinkSecurity;
import org.sami.boat.link.security.OpenLinks;
import org.sami.boat.link.security.PairingResponder;
import org.sami.boat.link.security.Peer;
import org.sami.boat.link.security.TlsLinks;
import org.sami.boat.server.tcp.TcpServerConfig;
import org.sami.crw.proxy.tcp.TcpBaseConfig;

/** How boats and bases of a test are linked: plainly, or with keys of which all are paired with one another. */
class TestLinks {
    private TestLinks() {}

    static TestLinks plain() {
        return new TestLinks();
    }

    static Keys withKeys() {
        return new Keys();
    }

    UnaryOperator<TcpServerConfig> ofBoat(String name) {
        return UnaryOperator.identity();
    }

    TcpBaseConfig ofBase(TcpBaseConfig plain) {
        return plain;
    }

    /** The boat's part in a link, for who speaks as a boat and is none. */
    LinkSecurity ofPeer(String name) {
        return new OpenLinks();
    }

    /** The base's part in a link, for who connects to a boat in its place. */
    LinkSecurity ofBaseItself() {
        return new OpenLinks();
    }

    /** Links over TLS. All bases have one key, each boat has its own, also after a restart. */
    static final class Keys extends TestLinks {
        final KeyRing base = KeyRing.inMemory();
        private final Map<String, KeyRing> boats = new ConcurrentHashMap<>();

        KeyRing boat(String name) {
            return boats.computeIfAbsent(name, this::paired);
        }

        private KeyRing paired(String name) {
            try {
                KeyRing boat = KeyRing.inMemory();
                boat.add(new Peer(base.identity().fingerprint(), "base", Role.COMMANDER));
                base.add(new Peer(boat.identity().fingerprint(), name, Role.OBSERVER));
                return boat;
            } catch (IOException e) {
                throw new UncheckedIOException(e);
            }
        }

        @Override
        UnaryOperator<TcpServerConfig> ofBoat(String name) {
            KeyRing ring = boat(name);
            return plain -> plain.withKeys(ring, new PairingResponder(ring));
        }

        @Override
        TcpBaseConfig ofBase(TcpBaseConfig plain) {
            return plain.withSecurity(TlsLinks.of(base));
        }

        @Override
        LinkSecurity ofPeer(String name) {
            return TlsLinks.of(boat(name));
        }

        @Override
        LinkSecurity ofBaseItself() {
            return TlsLinks.of(base);
        }
    }
}
