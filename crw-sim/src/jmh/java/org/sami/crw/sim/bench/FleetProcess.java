package org.sami.crw.sim.bench;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.sami.boat.link.Role;
import org.sami.boat.link.SteadyClock;
import org.sami.boat.link.security.Fingerprint;
import org.sami.boat.link.security.KeyRing;
import org.sami.boat.link.security.PairingResponder;
import org.sami.boat.link.security.Peer;
import org.sami.boat.server.tcp.TcpServerListener;
import org.sami.crw.sim.boat.BoatOnTcp;
import org.sami.crw.sim.boat.BoatSettings;
import org.sami.spn.value.GeoPoint;

/** Boats behind TCP in a process of their own, so that what they need is not counted for the base. They end with the base. */
public final class FleetProcess implements AutoCloseable {
    /** The pier along which the boats are launched: its western end. */
    public static final GeoPoint PIER = GeoPoint.of(45.4, 10.9);

    private static final double BERTH_DEG =
            1e-4; // 7.8 m at this latitude, so that boats that set out side by side keep clear of one another

    private final Process process;
    private final List<InetSocketAddress> addresses = new ArrayList<>();

    /** Begins the process; its boats are named "boat1" and so on, and linked plainly. */
    public FleetProcess(int boats) throws IOException {
        this(boats, Optional.empty());
    }

    /** The same with a base's keys: boats and base are paired with one another, and linked by TLS. */
    public FleetProcess(int boats, Optional<KeyRing> base) throws IOException {
        process = new ProcessBuilder(
                        Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                        "-cp",
                        System.getProperty("java.class.path"),
                        "-Xss256k",
                        FleetProcess.class.getName(),
                        "" + boats,
                        base.map(keys -> keys.identity().fingerprint().toString())
                                .orElse(""))
                .redirectError(ProcessBuilder.Redirect.INHERIT)
                .start();
        BufferedReader out =
                new BufferedReader(new InputStreamReader(process.getInputStream(), StandardCharsets.UTF_8));
        for (int i = 0; i < boats; i++) {
            String port = out.readLine();
            if (port == null) {
                throw new IOException("the boats' process has ended");
            }
            String[] parts = port.split(" ");
            addresses.add(new InetSocketAddress(InetAddress.getLoopbackAddress(), Integer.parseInt(parts[0])));
            if (base.isPresent()) {
                base.get().add(new Peer(Fingerprint.parse(parts[1]), "boat" + (i + 1), Role.OBSERVER));
            }
        }
    }

    /** Where a boat is launched, by its number from 1. */
    public static GeoPoint berth(int boat) {
        return GeoPoint.of(PIER.latDeg(), PIER.lonDeg() + boat * BERTH_DEG);
    }

    /** Processor time that the boats have needed so far, in ns. */
    public long cpuNanos() {
        return process.info().totalCpuDuration().orElse(Duration.ZERO).toNanos();
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

    /** The boats' process, given their number and the key of their base, or nothing: prints a port, and a key, a boat, and runs until its input ends. */
    public static void main(String[] args) throws IOException {
        InetSocketAddress anyPort = new InetSocketAddress(InetAddress.getLoopbackAddress(), 0);
        int boats = Integer.parseInt(args[0]);
        for (int i = 1; i <= boats; i++) {
            KeyRing keys = KeyRing.inMemory();
            if (!args[1].isEmpty()) {
                keys.add(new Peer(Fingerprint.parse(args[1]), "base", Role.COMMANDER));
            }
            BoatOnTcp boat = new BoatOnTcp(
                    BoatSettings.of("boat" + i, anyPort, berth(i), i),
                    SteadyClock.ofThisMachine(),
                    TcpServerListener.NONE,
                    plain -> args[1].isEmpty() ? plain : plain.withKeys(keys, new PairingResponder(keys)));
            System.out.println(boat.address().getPort() + " " + keys.identity().fingerprint());
        }
        while (System.in.read() >= 0) {
            // nothing is expected: the end is
        }
        System.exit(0);
    }
}
