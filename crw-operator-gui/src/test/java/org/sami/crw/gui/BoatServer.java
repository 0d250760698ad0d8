package org.sami.crw.gui;

import java.io.IOException;
import java.net.InetAddress;
import java.nio.file.Files;
import java.nio.file.Path;
import org.sami.boat.server.testing.OwnPort;
import org.sami.crw.cli.Crw;
import org.sami.crw.proxy.tcp.BoatAddress;
import org.sami.spn.testing.JavaProcess;

/** A simulated boat's server as a process of its own, with the boat's log in a folder; it can be killed and started again at its address. */
final class BoatServer implements AutoCloseable {
    private final String name;
    private final String at;
    private final Path logs;
    private final int port;
    private Process process;

    /**
     * Starts one.
     *
     * @param at latitude and longitude in degrees
     * @param logs the folder of its log
     */
    BoatServer(String name, String at, Path logs) throws IOException {
        this.name = name;
        this.at = at;
        this.logs = logs;
        port = OwnPort.draw();
        start();
    }

    /** Starts it again, where it was killed. */
    void start() throws IOException {
        process = JavaProcess.builder(
                        logs,
                        Crw.class,
                        "boat",
                        "--port",
                        String.valueOf(port),
                        "--name",
                        name,
                        "--at",
                        at,
                        "--log",
                        logs.toString(),
                        "--while-input")
                .redirectOutput(ProcessBuilder.Redirect.DISCARD)
                .redirectError(ProcessBuilder.Redirect.DISCARD)
                .start();
    }

    /** As {@code kill -9}. */
    void kill() throws InterruptedException {
        process.destroyForcibly().waitFor();
    }

    BoatAddress address() {
        return new BoatAddress(InetAddress.getLoopbackAddress().getHostAddress(), port);
    }

    /** What the boat has written down. */
    String log() throws IOException {
        return Files.readString(logs.resolve(name + ".log"));
    }

    @Override
    public void close() throws InterruptedException {
        kill();
    }
}
