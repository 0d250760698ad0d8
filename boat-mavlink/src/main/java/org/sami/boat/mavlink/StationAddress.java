package org.sami.boat.mavlink;

import org.sami.mavlink.address.AddressText;
import org.sami.mavlink.address.MavlinkAddress;

/** Reads the address of a ground station, as people write it for boats: the addresses of vehicles, with or without their prefix, and {@code udp:HOST:PORT} for a station that listens. */
public final class StationAddress {
    /** How addresses are written, for messages and help. */
    public static final String FORMS =
            "udp:HOST:PORT (a station that listens, usually on 14550), udp:PORT (the boat listens), tcp:HOST:PORT or"
                    + " serial:DEVICE:BAUD";

    private static final String UDP = "udp:";

    private StationAddress() {}

    /**
     * Reads an address.
     *
     * @throws IllegalArgumentException if it has none of the forms; the message says what is wrong and which forms there are
     */
    public static MavlinkAddress parse(String text) {
        String plain = MavlinkAddress.isOne(text) ? text.substring(MavlinkAddress.PREFIX.length()) : text;
        boolean sends = plain.startsWith(UDP) && plain.indexOf(':', UDP.length()) >= 0;
        String whole = MavlinkAddress.PREFIX + (sends ? "udpout:" + plain.substring(UDP.length()) : plain);
        try {
            return AddressText.parse(whole);
        } catch (IllegalArgumentException e) {
            Throwable cause = e.getCause() == null ? e : e.getCause();
            throw new IllegalArgumentException(
                    "\"" + text + "\" is no address of a ground station: " + cause.getMessage() + "; it is " + FORMS,
                    e);
        }
    }
}
