package org.sami.boat.app.screen;

import java.net.Inet4Address;
import java.net.InetAddress;
import java.net.NetworkInterface;
import java.net.SocketException;
import java.util.Collections;
import java.util.Enumeration;

/** The address of this phone in its network. */
final class PhoneAddress {
    private PhoneAddress() {}

    /** The first address of version 4 that is not the phone's own; empty text for none. */
    static String now() {
        try {
            Enumeration<NetworkInterface> all = NetworkInterface.getNetworkInterfaces();
            for (NetworkInterface each :
                    all == null ? Collections.<NetworkInterface>emptyList() : Collections.list(all)) {
                for (InetAddress address : Collections.list(each.getInetAddresses())) {
                    if (address instanceof Inet4Address && !address.isLoopbackAddress()) {
                        return String.valueOf(address.getHostAddress());
                    }
                }
            }
        } catch (SocketException e) {
            return ""; // it is in no network just now
        }
        return "";
    }
}
