package org.sami.crw.proxy.phone;

import java.io.IOException;
import java.net.Inet4Address;
import java.net.InetAddress;
import java.net.NetworkInterface;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Objects;

/**
 * A network in which this computer is.
 *
 * @param name of the computer's interface, as {@code wlan0}
 * @param address of this computer in it, IPv4
 */
public record OwnNetwork(String name, InetAddress address) {
    public OwnNetwork {
        Objects.requireNonNull(name, "name");
        Objects.requireNonNull(address, "address");
    }

    /**
     * The networks through which others reach this computer, wireless ones first.
     *
     * @throws IOException if they cannot be listed
     */
    public static List<OwnNetwork> all() throws IOException {
        List<OwnNetwork> wireless = new ArrayList<>();
        List<OwnNetwork> others = new ArrayList<>();
        for (NetworkInterface network : Collections.list(NetworkInterface.getNetworkInterfaces())) {
            if (network.isUp() && !network.isLoopback()) {
                List<OwnNetwork> kind = network.getName().startsWith("w") ? wireless : others;
                Collections.list(network.getInetAddresses()).stream()
                        .filter(Inet4Address.class::isInstance)
                        .forEach(address -> kind.add(new OwnNetwork(network.getName(), address)));
            }
        }
        wireless.addAll(others);
        return wireless;
    }

    /** For people: {@code 192.168.43.2 (wlan0)}. */
    @Override
    public String toString() {
        return address.getHostAddress() + " (" + name + ")";
    }
}
