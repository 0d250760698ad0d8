package org.sami.crw.cli.board;

import org.sami.boat.hull.nmea.GpsdReader;
import org.sami.boat.hull.stream.StreamPort;
import org.sami.boat.hull.stream.TcpPort;

/**
 * A device as it is written on the command line.
 *
 * @param port where it is reached
 * @param gpsd whether it is a gpsd
 * @param serial whether it is a serial port
 */
record DevicePort(StreamPort port, boolean gpsd, boolean serial) {
    private static final int MOST_BAUD = 4_000_000;
    private static final String GPSD = "gpsd";

    /**
     * Reads {@code HOST:PORT}, or a serial port with its rate, as {@code /dev/ttyACM0@115200}.
     *
     * @throws IllegalArgumentException that says what is expected
     */
    static DevicePort board(String text, int usualBaud) {
        int colon = text.lastIndexOf(':');
        if (colon >= 0) {
            return new DevicePort(tcp(text.substring(0, colon), text.substring(colon + 1), text), false, false);
        }
        int at = text.lastIndexOf('@');
        String device = at < 0 ? text : text.substring(0, at);
        if (device.isBlank()) {
            throw unfit(text);
        }
        int baud = at < 0 ? usualBaud : number(text.substring(at + 1), MOST_BAUD, text);
        return new DevicePort(new SerialStreamPort(device, baud), false, true);
    }

    /** Reads the same, and {@code gpsd} or {@code gpsd:HOST:PORT}. */
    static DevicePort gps(String text, int usualBaud) {
        if (!text.equals(GPSD) && !text.startsWith(GPSD + ":")) {
            return board(text, usualBaud);
        }
        String where = text.equals(GPSD) ? "127.0.0.1:" + GpsdReader.PORT : text.substring(GPSD.length() + 1);
        int colon = where.lastIndexOf(':');
        if (colon < 0) {
            throw unfit(text);
        }
        return new DevicePort(tcp(where.substring(0, colon), where.substring(colon + 1), text), true, false);
    }

    private static StreamPort tcp(String host, String port, String text) {
        if (host.isBlank()) {
            throw unfit(text);
        }
        return new TcpPort(host, number(port, 65_535, text));
    }

    private static int number(String digits, int most, String text) {
        try {
            int number = Integer.parseInt(digits);
            if (number >= 1 && number <= most) {
                return number;
            }
        } catch (NumberFormatException e) {
            // said below
        }
        throw unfit(text);
    }

    private static IllegalArgumentException unfit(String text) {
        return new IllegalArgumentException("expected is HOST:PORT, or a serial port such as /dev/ttyACM0, COM3 or"
                + " /dev/ttyUSB0@9600, not '" + text + "'");
    }
}
