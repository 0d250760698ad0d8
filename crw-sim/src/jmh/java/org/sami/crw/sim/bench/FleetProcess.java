package org.sami.crw.sim.bench;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.sami.boat.link.SteadyClock;
import org.sami.boat.server.tcp.TcpServerListener;
import org.sami.crw.sim.boat.BoatOnTcp;
import org.sami.crw.sim.boat.BoatSettings;
import org.sami.spn.value.GeoPoint;

/** Boats behind TCP in a process of their own, so that what they need is not counted for the base. They end with the base. */
public final class FleetProcess implements AutoCloseable {
    /** Where the boats are launched. */
    public static final GeoPoint PIER = GeoPoint.of(45.4, 10.9);

    private final Process process;
    private final List<InetSocketAddress> addresses = new ArrayList<>();

    /** Begins the process; its boats are named "boat1" and so on. */
    public FleetProcess(int boats) throws IOException {
        process = new ProcessBuilder(
                        Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                        "-cp",
                        System.getProperty("java.class.path"),
                        "-Xss256k",
                        FleetProcess.class.getName(),
                        "" + boats)
                .redirectError(ProcessBuilder.Redirect.INHERIT)
                .start();
        BufferedReader out =
                new BufferedReader(new InputStreamReader(process.getInputStream(), StandardCharsets.UTF_8));
        for (int i = 0; i < boats; i++) {
            String port = out.readLine();
            if (port == null) {
                throw new IOException("the boats' process has ended");
            }
            addresses.add(new InetSocketAddress(InetAddress.getLoopbackAddress(), Integer.parseInt(port)));
        }
    }

    /** Where the boats listen, in order. */
    public List<InetSocketAddress> addresses() {
        return addresses;
    }

    @Override
    public void close() throws InterruptedException {
        process.destroy();
        process.waitFor();
    }

    /** The boats' process: prints a port a boat, and runs until its input ends. */
    public static void main(String[] args) throws IOException {
        InetSocketAddress anyPort = new InetSocketAddress(InetAddress.getLoopbackAddress(), 0);
        int boats = Integer.parseInt(args[0]);
        for (int i = 1; i <= boats; i++) {
            BoatOnTcp boat = new BoatOnTcp(
                    BoatSettings.of("boat" + i, anyPort, PIER, i), SteadyClock.ofThisMachine(), TcpServerListener.NONE);
            System.out.println(boat.address().getPort());
        }
        while (System.in.read() >= 0) {
            // nothing is expected: the end is
        }
        System.exit(0);
    }
}
