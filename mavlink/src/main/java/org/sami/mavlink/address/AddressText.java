package org.sami.mavlink.address;

import java.util.Objects;

/** Reads addresses and checks their parts. */
final class AddressText {
    private static final int MAX_PORT = 65_535;
    private static final int MIN_BAUD = 1_200;
    private static final int MAX_BAUD = 4_000_000;

    private AddressText() {}

    static MavlinkAddress parse(String text) {
        Objects.requireNonNull(text, "text");
        try {
            if (!MavlinkAddress.isOne(text)) {
                throw new IllegalArgumentException("it does not begin with " + MavlinkAddress.PREFIX);
            }
            String rest = text.substring(MavlinkAddress.PREFIX.length());
            int colon = rest.indexOf(':');
            String kind = colon < 0 ? rest : rest.substring(0, colon);
            String where = colon < 0 ? "" : rest.substring(colon + 1);
            return switch (kind) {
                case "tcp" -> new MavlinkAddress.Tcp(before(where), number("port", after(where)));
                case "udp" -> new MavlinkAddress.UdpListen(number("port", where));
                case "udpout" -> new MavlinkAddress.UdpSend(before(where), number("port", after(where)));
                case "serial" -> new MavlinkAddress.Serial(before(where), number("baud rate", after(where)));
                default -> throw new IllegalArgumentException("there is no kind of link \"" + kind + "\"");
            };
        } catch (IllegalArgumentException e) {
            throw new IllegalArgumentException(
                    "\"" + text + "\" is no MAVLink address: " + e.getMessage() + "; it is " + MavlinkAddress.FORMS, e);
        }
    }

    /** What stands before the last colon: hosts of IPv6 and devices may have colons themselves. */
    private static String before(String where) {
        int colon = where.lastIndexOf(':');
        return colon < 0 ? where : where.substring(0, colon);
    }

    private static String after(String where) {
        int colon = where.lastIndexOf(':');
        return colon < 0 ? "" : where.substring(colon + 1);
    }

    private static int number(String what, String digits) {
        try {
            return Integer.parseInt(digits);
        } catch (NumberFormatException e) {
            throw new IllegalArgumentException(
                    digits.isEmpty() ? "the " + what + " is missing" : "the " + what + " is no whole number: " + digits,
                    e);
        }
    }

    static void checkHost(String host) {
        Objects.requireNonNull(host, "host");
        if (host.isBlank()) {
            throw new IllegalArgumentException("the host is missing");
        }
    }

    static void checkPort(int port) {
        if (port < 1 || port > MAX_PORT) {
            throw new IllegalArgumentException("a port is 1 to " + MAX_PORT + ", not " + port);
        }
    }

    static void checkBaud(int baud) {
        if (baud < MIN_BAUD || baud > MAX_BAUD) {
            throw new IllegalArgumentException("a baud rate is " + MIN_BAUD + " to " + MAX_BAUD + ", not " + baud);
        }
    }
}
