package org.sami.mavlink.testing;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.Socket;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import org.jline.terminal.Attributes;
import org.jline.terminal.Size;
import org.jline.terminal.impl.jni.JniNativePty;
import org.jline.terminal.impl.jni.JniTerminalProvider;

/**
 * A serial port of this machine without hardware, with a cable to a vehicle that listens on a TCP port: a pseudo terminal, as the kernel gives it, under a name of the test's own.
 * It can be pulled out and plugged in again, as an adapter on USB: the port vanishes and comes back under the same name. For one thread; needs Linux.
 */
public final class SerialCable implements AutoCloseable {
    private static final int AT_ONCE = 4096;

    private final Path device;
    private final int vehiclePort;
    private Optional<Plugged> plugged = Optional.empty();

    /**
     * Plugs it in.
     *
     * @param device the name of the port, which is not there yet
     * @param vehicleAddress of a vehicle on this machine, such as {@code mavlink:tcp:127.0.0.1:5760}
     */
    public SerialCable(Path device, String vehicleAddress) throws IOException {
        this.device = device;
        vehiclePort = Integer.parseInt(vehicleAddress.substring(vehicleAddress.lastIndexOf(':') + 1));
        plugIn();
    }

    /** Its address for a base. */
    public String address() {
        return "mavlink:serial:" + device + ":57600";
    }

    /** The port is there from now on. */
    public void plugIn() throws IOException {
        if (plugged.isEmpty()) {
            plugged = Optional.of(new Plugged(vehiclePort));
            Files.createSymbolicLink(device, Path.of(plugged.get().pty.getName()));
        }
    }

    /** The port is gone from now on, and whoever had opened it finds that. */
    public void pullOut() throws IOException {
        if (plugged.isPresent()) {
            Files.delete(device);
            plugged.get().end();
            plugged = Optional.empty();
        }
    }

    @Override
    public void close() throws IOException {
        pullOut();
    }

    /** The pair of ends while it is plugged in, with a thread a direction. */
    private static final class Plugged {
        private final JniNativePty pty;
        private final Socket vehicle;
        private final Thread toVehicle;
        private final Thread fromVehicle;
        private volatile boolean ended;

        Plugged(int vehiclePort) throws IOException {
            pty = (JniNativePty) new JniTerminalProvider().open(raw(), Size.of(80, 24));
            vehicle = new Socket(InetAddress.getLoopbackAddress(), vehiclePort);
            InputStream fromPort = pty.getMasterInput();
            OutputStream toPort = pty.getMasterOutput();
            InputStream fromSocket = vehicle.getInputStream();
            OutputStream toSocket = vehicle.getOutputStream();
            toVehicle = begin(() -> pass(fromPort, toSocket));
            fromVehicle = begin(() -> pass(fromSocket, toPort));
        }

        /** All bytes pass as they are, and nothing is echoed: also before a base has set the port up. */
        private static Attributes raw() {
            Attributes raw = new Attributes();
            raw.setControlFlag(Attributes.ControlFlag.CS8, true);
            raw.setControlFlag(Attributes.ControlFlag.CREAD, true);
            raw.setControlChar(Attributes.ControlChar.VMIN, 1);
            return raw;
        }

        private static Thread begin(Runnable work) {
            Thread thread = new Thread(work, "serial cable");
            thread.setDaemon(true);
            thread.start();
            return thread;
        }

        private void pass(InputStream from, OutputStream to) {
            byte[] bytes = new byte[AT_ONCE];
            try {
                for (int read = from.read(bytes); read >= 0 && !ended; read = from.read(bytes)) {
                    to.write(bytes, 0, read);
                    to.flush();
                }
            } catch (IOException e) {
                // one of the ends is gone
            }
        }

        /** A read under way would keep the terminal open: so each of both ends first. */
        void end() throws IOException {
            ended = true;
            vehicle.close();
            pty.getSlaveOutput().write(0); // has the reader of the port look again
            try {
                toVehicle.join();
                fromVehicle.join();
            } catch (InterruptedException e) {
                Thread.currentThread().interrupt();
            }
            pty.close();
        }
    }
}
