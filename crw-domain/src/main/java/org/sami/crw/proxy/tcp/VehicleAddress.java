package org.sami.crw.proxy.tcp;

import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Addresses of vehicles that speak MAVLink, as people write them: a link, and after a slash the number of a vehicle on it ({@code mavlink:udp:14550/3}), or the
 * first and last of several ({@code mavlink:udp:14550/1-5}). Without a number all vehicles are meant that are heard there.
 */
final class VehicleAddress {
    /** Stands for the number of a vehicle where all on the link are meant. */
    static final int EVERY_VEHICLE = 256;

    private static final String PREFIX = "mavlink:";
    private static final int LAST_VEHICLE = 255;
    private static final Pattern FORM =
            Pattern.compile("(?<link>mavlink:(?:tcp:[^/,]+:[0-9]{1,5}|udpout:[^/,]+:[0-9]{1,5}|udp:[0-9]{1,5}"
                    + "|serial:[^,]+:[0-9]{4,7}))(?:/(?<first>[0-9]{1,3})(?:-(?<last>[0-9]{1,3}))?)?");

    private VehicleAddress() {}

    /** Whether a text, or the host of an address, is meant as one of these; it may have faults still. */
    static boolean isOne(String text) {
        return text.startsWith(PREFIX);
    }

    /**
     * Reads one, which may stand for several vehicles.
     *
     * @throws IllegalArgumentException saying what is allowed
     */
    static List<BoatAddress> parseAll(String text) {
        Matcher form = FORM.matcher(text.strip());
        if (form.matches()) {
            String link = form.group("link");
            if (form.group("first") == null) {
                return List.of(new BoatAddress(link, EVERY_VEHICLE));
            }
            int first = Integer.parseInt(form.group("first"));
            int last = form.group("last") == null ? first : Integer.parseInt(form.group("last"));
            if (first >= 1 && first <= last && last <= LAST_VEHICLE) {
                List<BoatAddress> all = new ArrayList<>();
                for (int vehicle = first; vehicle <= last; vehicle++) {
                    all.add(new BoatAddress(link, vehicle));
                }
                return all;
            }
        }
        throw new IllegalArgumentException("'" + text
                + "' is no MAVLink address: it is mavlink:tcp:HOST:PORT, mavlink:udp:PORT, mavlink:udpout:HOST:PORT or mavlink:serial:DEVICE:BAUD,"
                + " and after it /N for the vehicle of system id N, or /N-M");
    }

    /** As people write it. */
    static String text(String link, int vehicle) {
        return vehicle == EVERY_VEHICLE ? link : link + "/" + vehicle;
    }
}
