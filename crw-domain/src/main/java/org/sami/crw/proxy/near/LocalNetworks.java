package org.sami.crw.proxy.near;

import java.io.IOException;
import java.net.Inet4Address;
import java.net.InetAddress;
import java.net.NetworkInterface;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import javax.jmdns.JmDNS;
import org.sami.boat.link.BoatAnnouncement;

/** The networks of this machine on which boats are announced and looked for: one address of each, IPv4. */
final class LocalNetworks {
    /** The service type as JmDNS names it. */
    static final String TYPE = BoatAnnouncement.SERVICE_TYPE + ".local.";

    /** How long others keep an announcement that is not repeated, in seconds; it is repeated after half of that. */
    static final int KEPT_S = 60;

    static {
        if (System.getProperty("net.dns.ttl") == null) { // JmDNS reads it once, for the whole process
            System.setProperty("net.dns.ttl", Integer.toString(KEPT_S));
        }
    }

    private LocalNetworks() {}

    /**
     * All networks, and this machine itself.
     *
     * @throws IOException if they cannot be listed
     */
    static List<InetAddress> all() throws IOException {
        List<InetAddress> addresses = new ArrayList<>(ofOthers());
        addresses.add(InetAddress.getLoopbackAddress());
        return addresses;
    }

    /** Those from which a server at this address is reached: its own, or all of other machines if it listens everywhere. */
    static List<InetAddress> of(InetAddress server) throws IOException {
        return server.isAnyLocalAddress() ? ofOthers() : List.of(server);
    }

    private static List<InetAddress> ofOthers() throws IOException {
        List<InetAddress> addresses = new ArrayList<>();
        for (NetworkInterface network : Collections.list(NetworkInterface.getNetworkInterfaces())) {
            if (network.isUp() && !network.isLoopback() && network.supportsMulticast()) {
                Collections.list(network.getInetAddresses()).stream()
                        .filter(Inet4Address.class::isInstance)
                        .findFirst()
                        .ifPresent(addresses::add);
            }
        }
        return addresses;
    }

    /**
     * A responder and asker on one network; its close takes seconds.
     *
     * @throws IOException if it is no address of this machine, or its network has no multicast
     */
    static JmDNS open(InetAddress address) throws IOException {
        if (NetworkInterface.getByInetAddress(address) == null) { // JmDNS would take any other
            throw new IOException("no network of this machine has the address " + address.getHostAddress());
        }
        return JmDNS.create(address, null);
    }
}
