package org.sami.mavlink.address;

import java.util.Objects;
import java.util.OptionalInt;

/**
 * Where vehicles are reached, in the four forms that people know from ground stations: {@code mavlink:tcp:HOST:PORT}, {@code mavlink:udp:PORT} (listens),
 * {@code mavlink:udpout:HOST:PORT} (sends first) and {@code mavlink:serial:DEVICE:BAUD}; {@code ?baud=N} after a port says that a radio of this speed is behind it.
 * Equal addresses are written equally ({@code toString}).
 */
public sealed interface MavlinkAddress {
    /** How addresses are written, for messages and help. */
    String FORMS = "mavlink:tcp:HOST:PORT, mavlink:udp:PORT, mavlink:udpout:HOST:PORT or mavlink:serial:DEVICE:BAUD;"
            + " ?baud=N after a port says that a radio of this speed is behind it";

    /** What all addresses begin with; others are those of the project's own boats. */
    String PREFIX = "mavlink:";

    /** What the link carries, in baud; empty for networks, where that does not matter. */
    OptionalInt speedBaud();

    /** The end of this machine, or the port of another one, without the speed: a link that is open there leaves no room for one at another speed. */
    String place();

    /** A TCP server: an autopilot's simulator, or a router of links. */
    record Tcp(String host, int port, OptionalInt speedBaud) implements MavlinkAddress {
        /** An address.
         *
         * @throws IllegalArgumentException if the host is empty, the port is not 1 to 65535, or the speed is not 1200 to 4000000 baud
         */
        public Tcp {
            AddressChecks.checkHost(host);
            AddressChecks.checkPort(port);
            speedBaud.ifPresent(AddressChecks::checkBaud);
        }

        /** A network all the way. */
        public Tcp(String host, int port) {
            this(host, port, OptionalInt.empty());
        }

        @Override
        public String place() {
            return PREFIX + "tcp:" + host + ":" + port;
        }

        @Override
        public String toString() {
            return place() + RadioSpeed.text(speedBaud);
        }
    }

    /** A UDP port of this machine to which vehicles send. They are answered at the address from which each was heard last. */
    record UdpListen(int port, OptionalInt speedBaud) implements MavlinkAddress {
        /** An address.
         *
         * @throws IllegalArgumentException if the port is not 1 to 65535, or the speed not 1200 to 4000000 baud
         */
        public UdpListen {
            AddressChecks.checkPort(port);
            speedBaud.ifPresent(AddressChecks::checkBaud);
        }

        @Override
        public String place() {
            return PREFIX + "udp:" + port;
        }

        @Override
        public String toString() {
            return place() + RadioSpeed.text(speedBaud);
        }
    }

    /** A UDP port of another machine, which answers once it is sent something. */
    record UdpSend(String host, int port, OptionalInt speedBaud) implements MavlinkAddress {
        /** An address.
         *
         * @throws IllegalArgumentException if the host is empty, the port is not 1 to 65535, or the speed is not 1200 to 4000000 baud
         */
        public UdpSend {
            AddressChecks.checkHost(host);
            AddressChecks.checkPort(port);
            speedBaud.ifPresent(AddressChecks::checkBaud);
        }

        /** A network all the way. */
        public UdpSend(String host, int port) {
            this(host, port, OptionalInt.empty());
        }

        @Override
        public String place() {
            return PREFIX + "udpout:" + host + ":" + port;
        }

        @Override
        public String toString() {
            return place() + RadioSpeed.text(speedBaud);
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
        public OptionalInt speedBaud() {
            return OptionalInt.of(baud);
        }

        @Override
        public String place() {
            return PREFIX + "serial:" + device;
        }

        @Override
        public String toString() {
            return place() + ":" + baud;
        }
    }

    /** Whether a text is meant as one of these addresses; it may have faults still. */
    static boolean isOne(String text) {
        return text.startsWith(PREFIX);
    }
}
