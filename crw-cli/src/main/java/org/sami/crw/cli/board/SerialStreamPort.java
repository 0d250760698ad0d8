package org.sami.crw.cli.board;

import com.fazecast.jSerialComm.SerialPort;
import com.fazecast.jSerialComm.SerialPortInvalidPortException;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.stream.Collectors;
import org.sami.boat.hull.stream.StreamConnection;
import org.sami.boat.hull.stream.StreamPort;

/** A serial port of this machine, 8 data bits, no parity, one stop bit. */
final class SerialStreamPort implements StreamPort {
    private final String device;
    private final int baud;

    SerialStreamPort(String device, int baud) {
        this.device = device;
        this.baud = baud;
    }

    @Override
    public String name() {
        return device;
    }

    @Override
    public StreamConnection open() throws IOException {
        SerialPort port = found();
        port.setComPortParameters(baud, 8, SerialPort.ONE_STOP_BIT, SerialPort.NO_PARITY);
        port.setComPortTimeouts(SerialPort.TIMEOUT_READ_SEMI_BLOCKING, 0, 0);
        if (!port.openPort()) {
            throw new IOException(refusal());
        }
        return new SerialConnection(port);
    }

    private SerialPort found() throws IOException {
        if (device.startsWith("/") && Files.notExists(Path.of(device))) {
            throw new IOException("there is no such port");
        }
        try {
            return SerialPort.getCommPort(device);
        } catch (SerialPortInvalidPortException e) {
            throw new IOException("there is no such port", e);
        }
    }

    private String refusal() {
        Path path = Path.of(device);
        boolean denied = device.startsWith("/") && !(Files.isReadable(path) && Files.isWritable(path));
        return denied
                ? "this user may not use it: join the group that owns it (often dialout), and log in again"
                : "it cannot be opened: another program may hold it";
    }

    /** The serial ports of this machine, in words. */
    static String present() {
        String names = Arrays.stream(SerialPort.getCommPorts())
                .map(SerialPort::getSystemPortPath)
                .sorted()
                .collect(Collectors.joining(", "));
        return names.isEmpty() ? "none is here" : "here are " + names;
    }

    /** An open port. */
    private record SerialConnection(SerialPort port) implements StreamConnection {
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
}
