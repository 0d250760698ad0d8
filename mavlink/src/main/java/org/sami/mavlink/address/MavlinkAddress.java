package org.sami.mavlink.address;

import java.util.Objects;

/**
 * Where vehicles are reached, in the four forms that people know from ground stations: {@code mavlink:tcp:HOST:PORT}, {@code mavlink:udp:PORT} (listens),
 * {@code mavlink:udpout:HOST:PORT} (sends first) and {@code mavlink:serial:DEVICE:BAUD}. Equal addresses are written equally ({@code toString}).
 */
public sealed interface MavlinkAddress {
    /** How addresses are written, for messages and help. */
    String FORMS = "mavlink:tcp:HOST:PORT, mavlink:udp:PORT, mavlink:udpout:HOST:PORT or mavlink:serial:DEVICE:BAUD";

    /** What all addresses begin with; others are those of the project's own boats. */
    String PREFIX = "mavlink:";

    /** A TCP server: an autopilot's simulator, or a router of links. */
    record Tcp(String host, int port) implements MavlinkAddress {
        /** An address.
         *
         * @throws IllegalArgumentException if the host is empty or the port is not 1 to 65535
         */
        public Tcp {
            AddressChecks.checkHost(host);
            AddressChecks.checkPort(port);
        }

        @Override
        public String toString() {
            return PREFIX + "tcp:" + host + ":" + port;
        }
    }

    /** A UDP port of this machine to which vehicles send. They are answered at the address from which each was heard last. */
    record UdpListen(int port) implements MavlinkAddress {
        /** An address.
         *
         * @throws IllegalArgumentException if the port is not 1 to 65535
         */
        public UdpListen {
            AddressChecks.checkPort(port);
        }

        @Override
        public String toString() {
            return PREFIX + "udp:" + port;
        }
    }

    /** A UDP port of another machine, which answers once it is sent something. */
    record UdpSend(String host, int port) implements MavlinkAddress {
        /** An address.
         *
         * @throws IllegalArgumentException if the host is empty or the port is not 1 to 65535
         */
        public UdpSend {
            AddressChecks.checkHost(host);
            AddressChecks.checkPort(port);
        }

        @Override
        public String toString() {
            return PREFIX + "udpout:" + host + ":" + port;
        }
    }

    /** A serial port: a radio's, or an autopilot's own. */
    record Serial(String device, int baud) implements MavlinkAddress {
        /** An address.
         *
         * @throws IllegalArgumentException if the device is empty or the rate is not 1200 to 4000000 baud
         */
        public Serial {
            Objects.requireNonNull(device, "device");
            if (device.isBlank()) {
                throw new IllegalArgumentException("the device is missing");
            }
            AddressChecks.checkBaud(baud);
        }

        @Override
        public String toString() {
            return PREFIX + "serial:" + device + ":" + baud;
        }
    }

    /** Whether a text is meant as one of these addresses; it may have faults still. */
    static boolean isOne(String text) {
        return text.startsWith(PREFIX);
    }
}
