package org.sami.crw.proxy.tcp;

import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;

/**
 * Vehicles that speak MAVLink, as people write their address: a link, and after a slash the number of a vehicle on it ({@code mavlink:udp:14550/3}), or the
 * first and last of several ({@code mavlink:udp:14550/1-5}). {@code ?baud=57600} before the slash says that a radio of this speed is behind a network's port. Without a number all vehicles are meant that are heard there.
 *
 * @param link without the numbers; begins with {@code mavlink:}
 * @param first system id of the first, or {@link #EVERY_VEHICLE}
 * @param last system id of the last, the same as the first for one
 */
record VehicleAddress(String link, int first, int last) {
    /** Stands for the number of a vehicle where all on the link are meant. */
    static final int EVERY_VEHICLE = 256;

    private static final String PREFIX = "mavlink:";
    private static final int LAST_VEHICLE = 255;
    private static final int LAST_PORT = 65_535;
    private static final int LEAST_BAUD = 1_200;
    private static final int MOST_BAUD = 4_000_000;
    private static final Pattern FORM = Pattern.compile(
            "(?<link>mavlink:(?:(?:(?:tcp:|udpout:)[^/,]+:|udp:)(?<port>[0-9]{1,7})(?:\\?baud=(?<speed>[0-9]{1,7}))?|serial:[^,]+:(?<baud>[0-9]{1,7})))(?:/(?<first>[0-9]{1,3})(?:-(?<last>[0-9]{1,3}))?)?");

    /** Whether a text, or the host of an address, is meant as one of these; it may have faults still. */
    static boolean isOne(String text) {
        return text.startsWith(PREFIX);
    }

    /**
     * Reads one, which may stand for several vehicles.
     *
     * @throws IllegalArgumentException saying what is allowed
     */
    static VehicleAddress parse(String text) {
        Matcher form = FORM.matcher(text.strip());
        if (!form.matches()) {
            throw unfit(text, mistake(text.strip().substring(PREFIX.length())));
        }
        check(text, "a port", form.group("port"), 1, LAST_PORT);
        check(text, "a baud rate", form.group("speed"), LEAST_BAUD, MOST_BAUD);
        check(text, "a baud rate", form.group("baud"), LEAST_BAUD, MOST_BAUD);
        if (form.group("first") == null) {
            return new VehicleAddress(form.group("link"), EVERY_VEHICLE, EVERY_VEHICLE);
        }
        int first = Integer.parseInt(form.group("first"));
        int last = form.group("last") == null ? first : Integer.parseInt(form.group("last"));
        if (first < 1 || Math.max(first, last) > LAST_VEHICLE) {
            throw unfit(
                    text,
                    "a system id is 1 to " + LAST_VEHICLE + ", not " + (first < 1 ? first : Math.max(first, last))
                            + "; ");
        }
        if (first > last) {
            throw unfit(text, "the first system id, " + first + ", is above the last, " + last + "; ");
        }
        return new VehicleAddress(form.group("link"), first, last);
    }

    /** What is wrong with an address that has no form of these, given without its prefix; empty where that is no usual mistake. */
    private static String mistake(String address) {
        String[] parts = address.split(":", -1);
        return switch (parts[0]) {
            case "udp" ->
                parts.length > 2
                        ? "udp listens on a port of this machine and takes no host; to a host it is udpout; "
                        : parts.length < 2 || parts[1].isEmpty() ? "the port is missing; " : "";
            case "tcp", "udpout" -> parts.length < 3 ? "the host or the port is missing; " : "";
            case "serial" -> parts.length < 3 ? "the device or the baud rate is missing; " : "";
            default -> "there is no kind of link '" + parts[0] + "'; ";
        };
    }

    private static void check(String text, String what, @Nullable String digits, int least, int most) {
        int number = digits == null ? least : Integer.parseInt(digits);
        if (number < least || number > most) {
            throw unfit(text, what + " is " + least + " to " + most + ", not " + number + "; ");
        }
    }

    private static IllegalArgumentException unfit(String text, String why) {
        return new IllegalArgumentException(
                "'" + text + "' is no MAVLink address: " + why + "it is mavlink:tcp:HOST:PORT, mavlink:udp:PORT,"
                        + " mavlink:udpout:HOST:PORT or"
                        + " mavlink:serial:DEVICE:BAUD, after a port ?baud=N where a radio of that speed is behind it, and"
                        + " at the end /N for the vehicle of system id N, or /N-M");
    }

    /** As people write it. */
    static String text(String link, int vehicle) {
        return vehicle == EVERY_VEHICLE ? link : link + "/" + vehicle;
    }
}
