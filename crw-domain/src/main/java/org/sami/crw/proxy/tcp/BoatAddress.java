package org.sami.crw.proxy.tcp;

import java.net.InetSocketAddress;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Objects;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.IntStream;

/**
 * Where a boat's server listens; or a MAVLink link with the number of a vehicle on it.
 *
 * @param host a name, an IPv4 address, or an IPv6 address without brackets, in small letters; of a vehicle the link, which begins with {@code mavlink:}
 * @param port 1 to 65535; of a vehicle its system id, or 256 for all that are heard on the link
 */
public record BoatAddress(String host, int port) {
    private static final int MAX_PORT = 65_535;
    private static final Pattern FORM =
            Pattern.compile("(?:\\[(?<ipv6>[0-9A-Fa-f:.]*:[0-9A-Fa-f:.]*(?:%[A-Za-z0-9]+)?)]|(?<name>[A-Za-z0-9._-]+))"
                    + ":(?<port>[0-9]{1,5})");

    public BoatAddress {
        Objects.requireNonNull(host, "host");
        host = VehicleAddress.isOne(host) ? host : host.toLowerCase(Locale.ROOT); // devices have capitals
        if (host.isEmpty() || port < 1 || port > MAX_PORT) {
            throw new IllegalArgumentException("no address of a boat: '" + host + "', port " + port);
        }
    }

    /**
     * Reads {@code HOST:PORT}; an IPv6 address stands in brackets.
     *
     * @throws IllegalArgumentException saying what is allowed
     */
    public static BoatAddress parse(String text) {
        if (VehicleAddress.isOne(text.strip())) {
            List<BoatAddress> all = vehicles(text);
            if (all.size() > 1) {
                throw new IllegalArgumentException("'" + text + "' are several vehicles, not one");
            }
            return all.get(0);
        }
        Matcher form = FORM.matcher(text.strip());
        if (form.matches()) {
            int port = Integer.parseInt(form.group("port"));
            if (port >= 1 && port <= MAX_PORT) {
                return new BoatAddress(form.group("ipv6") != null ? form.group("ipv6") : form.group("name"), port);
            }
        }
        throw new IllegalArgumentException(
                "'" + text + "' is no HOST:PORT; a port is 1 to 65535, an IPv6 address stands in brackets: [::1]:5001");
    }

    /**
     * Reads several, with commas between them.
     *
     * @throws IllegalArgumentException if one makes no sense or stands there twice
     */
    public static List<BoatAddress> parseAll(String text) {
        List<BoatAddress> all = new ArrayList<>();
        Set<BoatAddress> known = new HashSet<>();
        for (String part : text.split(",", -1)) {
            List<BoatAddress> meant = VehicleAddress.isOne(part.strip()) ? vehicles(part) : List.of(parse(part));
            for (BoatAddress next : meant) {
                if (!known.add(next)) {
                    throw new IllegalArgumentException(next + " stands there twice");
                }
                all.add(next);
            }
        }
        return all;
    }

    private static List<BoatAddress> vehicles(String text) {
        VehicleAddress all = VehicleAddress.parse(text);
        return IntStream.rangeClosed(all.first(), all.last())
                .mapToObj(vehicle -> new BoatAddress(all.link(), vehicle))
                .toList();
    }

    /** The address that a socket's is written as. */
    public static BoatAddress of(InetSocketAddress address) {
        return new BoatAddress(address.getHostString(), address.getPort());
    }

    /** Whether a text is meant as an address on a MAVLink link; what follows is not looked at. */
    public static boolean isOnMavlink(String text) {
        return VehicleAddress.isOne(text);
    }

    /** Whether it stands for all vehicles that are heard on its link. */
    public boolean isOfEveryVehicle() {
        return VehicleAddress.isOne(host) && port == VehicleAddress.EVERY_VEHICLE;
    }

    /** Whether a boat that is reached at another address is one of those at this. */
    public boolean leadsTo(BoatAddress other) {
        return equals(other) || (isOfEveryVehicle() && host.equals(other.host));
    }

    /** For a socket; a name is looked up when it is connected. */
    public InetSocketAddress toSocketAddress() {
        return InetSocketAddress.createUnresolved(host, port);
    }

    @Override
    public String toString() {
        if (VehicleAddress.isOne(host)) {
            return VehicleAddress.text(host, port);
        }
        return (host.contains(":") ? "[" + host + "]" : host) + ":" + port;
    }
}
