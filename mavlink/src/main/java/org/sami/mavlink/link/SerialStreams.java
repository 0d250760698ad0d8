package org.sami.mavlink.link;

import com.fazecast.jSerialComm.SerialPort;
import com.fazecast.jSerialComm.SerialPortInvalidPortException;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;

/** A serial port of this machine: 8 data bits, no parity, one stop bit. */
record SerialStreams(SerialPort port) implements LinkStreams {
    private static final int DATA_BITS = 8;

    static SerialStreams open(String device, int baud) throws IOException {
        SerialPort port = find(device);
        port.setComPortParameters(baud, DATA_BITS, SerialPort.ONE_STOP_BIT, SerialPort.NO_PARITY);
        port.setComPortTimeouts(SerialPort.TIMEOUT_READ_SEMI_BLOCKING, 0, 0);
        if (!port.openPort()) {
            throw new IOException(refusal(device));
        }
        return new SerialStreams(port);
    }

    private static SerialPort find(String device) throws IOException {
        if (device.startsWith("/") && Files.notExists(Path.of(device))) {
            throw new IOException(missing(device));
        }
        try {
            return SerialPort.getCommPort(device);
        } catch (SerialPortInvalidPortException e) {
            throw new IOException(missing(device), e);
        }
    }

    private static String missing(String device) {
        return "there is no port " + device + ": plug the radio in, or take the port that appears when you do (on Linux"
                + " /dev/ttyUSB0 or /dev/ttyACM0, on Windows COM3, …)";
    }

    private static String refusal(String device) {
        Path path = Path.of(device);
        boolean denied = device.startsWith("/") && !(Files.isReadable(path) && Files.isWritable(path));
        return denied
                ? "this user may not use " + device + ": join the group that owns it (often dialout), and log in again"
                : device + " cannot be opened: another program may hold it, or it is no serial port";
    }

    @Override
    public InputStream in() {
        return port.getInputStream();
    }

    @Override
    public OutputStream out() {
        return port.getOutputStream();
    }

    @Override
    public void close() {
        port.closePort();
    }
}
