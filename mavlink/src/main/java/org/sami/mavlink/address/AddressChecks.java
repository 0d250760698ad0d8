package org.sami.mavlink.address;

import java.util.Objects;

/** Refuses parts of addresses that cannot be. */
final class AddressChecks {
    private static final int MAX_PORT = 65_535;
    private static final int MIN_BAUD = 1_200;
    private static final int MAX_BAUD = 4_000_000;

    private AddressChecks() {}

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
