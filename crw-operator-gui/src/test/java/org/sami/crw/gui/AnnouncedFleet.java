package org.sami.crw.gui;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import org.sami.boat.link.BoatAnnouncement;
import org.sami.boat.link.BoatAnnouncement.Access;
import org.sami.boat.link.Role;
import org.sami.boat.link.SteadyClock;
import org.sami.boat.link.security.KeyRing;
import org.sami.boat.link.security.KeyStoreFolder;
import org.sami.boat.link.security.PairingResponder;
import org.sami.boat.link.security.Peer;
import org.sami.boat.server.tcp.TcpServerListener;
import org.sami.boat.server.testing.ProcessClock;
import org.sami.crw.proxy.near.BoatAnnouncer;
import org.sami.crw.sim.boat.BoatOnTcp;
import org.sami.crw.sim.boat.BoatSettings;
import org.sami.spn.value.GeoPoint;

/**
 * Simulated boats with keys in this process, in rows of five along the quay of Katara Beach, that announce themselves on this machine's loopback network. A base
 * whose keys are in the folder is paired with them; others that announce boats there are not.
 */
final class AnnouncedFleet implements AutoCloseable {
    private static final double APART_DEG = 0.0002; // 22 m
    private static final int IN_A_ROW = 5;

    private final List<BoatOnTcp> boats = new ArrayList<>();
    private final List<BoatAnnouncer> announcers = new ArrayList<>();

    /**
     * Launches one boat a name.
     *
     * @param baseKeys folder of the base's keys, to which those of the boats are added
     * @param unpaired name of one that the base is not paired with
     */
    AnnouncedFleet(List<String> names, Path baseKeys, String unpaired) throws IOException {
        KeyRing base = new KeyStoreFolder(baseKeys).open();
        List<CompletableFuture<BoatAnnouncer>> announcing = new ArrayList<>();
        for (String name : names) {
            KeyRing keys = KeyRing.inMemory();
            keys.add(new Peer(base.identity().fingerprint(), "base", Role.COMMANDER));
            if (!name.equals(unpaired)) {
                base.add(new Peer(keys.identity().fingerprint(), name, Role.COMMANDER));
            }
            BoatOnTcp boat = launch(name, keys);
            BoatAnnouncement says = BoatAnnouncement.of(
                            name, keys.identity().fingerprint().shortText(), Access.PAIRED, "simulated")
                    .withBattery(80);
            announcing.add(CompletableFuture.supplyAsync(() -> announce(says, boat.address())));
        }
        announcing.forEach(one -> announcers.add(one.join()));
    }

    private BoatOnTcp launch(String name, KeyRing keys) throws IOException {
        int row = boats.size() / IN_A_ROW;
        GeoPoint at = GeoPoint.of(
                LoopbackFleet.QUAY.latDeg() - boats.size() % IN_A_ROW * APART_DEG,
                LoopbackFleet.QUAY.lonDeg() + row * APART_DEG);
        BoatOnTcp boat = new BoatOnTcp(
                BoatSettings.of(name, new InetSocketAddress(InetAddress.getLoopbackAddress(), 0), at, boats.size()),
                new SteadyClock(ProcessClock::ms),
                TcpServerListener.NONE,
                plain -> plain.withKeys(keys, new PairingResponder(keys, (other, code) -> {})));
        boats.add(boat);
        return boat;
    }

    private static BoatAnnouncer announce(BoatAnnouncement says, InetSocketAddress at) {
        try {
            return BoatAnnouncer.open(() -> says, at);
        } catch (IOException noMulticast) {
            throw new CompletionException(noMulticast);
        }
    }

    @Override
    public void close() throws IOException {
        CompletableFuture.allOf(announcers.stream()
                        .map(one -> CompletableFuture.runAsync(one::close)) // each takes seconds
                        .toArray(CompletableFuture[]::new))
                .join();
        for (BoatOnTcp boat : boats) {
            boat.close();
        }
    }
}
