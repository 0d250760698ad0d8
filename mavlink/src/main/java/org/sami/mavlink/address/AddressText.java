package org.sami.mavlink.address;

import java.util.Objects;
import java.util.OptionalInt;

/** Reads addresses as people write them. */
public final class AddressText {
    private AddressText() {}

    /**
     * Reads an address.
     *
     * @throws IllegalArgumentException if it has none of the forms; the message says what is wrong and which forms there are
     */
    public static MavlinkAddress parse(String text) {
        Objects.requireNonNull(text, "text");
        try {
            if (!MavlinkAddress.isOne(text)) {
                throw new IllegalArgumentException("it does not begin with " + MavlinkAddress.PREFIX);
            }
            String rest = text.substring(MavlinkAddress.PREFIX.length());
            int colon = rest.indexOf(':');
            String kind = colon < 0 ? rest : rest.substring(0, colon);
            String all = colon < 0 ? "" : rest.substring(colon + 1);
            int option = all.indexOf('?');
            String where = option < 0 ? all : all.substring(0, option);
            OptionalInt speed = option < 0 ? OptionalInt.empty() : OptionalInt.of(speed(kind, all.substring(option)));
            return switch (kind) {
                case "tcp" -> new MavlinkAddress.Tcp(before(where), number("port", after(where)), speed);
                case "udp" -> new MavlinkAddress.UdpListen(number("port", ofThisMachine(where)), speed);
                case "udpout" -> new MavlinkAddress.UdpSend(before(where), number("port", after(where)), speed);
                case "serial" -> new MavlinkAddress.Serial(before(where), number("baud rate", after(where)));
                default -> throw new IllegalArgumentException("there is no kind of link \"" + kind + "\"");
            };
        } catch (IllegalArgumentException e) {
            throw new IllegalArgumentException(
                    "\"" + text + "\" is no MAVLink address: " + e.getMessage() + "; it is " + MavlinkAddress.FORMS, e);
        }
    }

    /** Of what stands after a port: the speed of the radio behind it. */
    private static int speed(String kind, String option) {
        if (kind.equals("serial")) {
            throw new IllegalArgumentException("a serial port has its baud rate, and nothing after it: " + option);
        } else if (!option.startsWith(RadioSpeed.OPTION)) {
            throw new IllegalArgumentException(
                    "after the port stands " + RadioSpeed.OPTION + "N or nothing, not " + option);
        }
        return number("baud rate", option.substring(RadioSpeed.OPTION.length()));
    }

    private static String ofThisMachine(String where) {
        if (where.contains(":")) {
            throw new IllegalArgumentException(
                    "udp listens on a port of this machine and takes no host; to a host it is udpout");
        }
        return where;
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
            if (digits.matches("[0-9]+/[0-9-]+")) {
                throw new IllegalArgumentException(
                        "what stands after the / names vehicles, and here a link is asked for, with all that are on it",
                        e);
            }
            throw new IllegalArgumentException(
                    digits.isEmpty() ? "the " + what + " is missing" : "the " + what + " is no whole number: " + digits,
                    e);
        }
    }
}
