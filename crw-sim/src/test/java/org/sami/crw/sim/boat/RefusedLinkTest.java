package org.sami.crw.sim.boat;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.sami.boat.link.LinkCodec;
import org.sami.boat.link.Role;
import org.sami.boat.link.Welcome;
import org.sami.boat.link.security.Fingerprint;
import org.sami.boat.link.security.Identity;
import org.sami.boat.link.security.Peer;
import org.sami.boat.link.security.TlsLinks;
import org.sami.boat.server.testing.Await;
import org.sami.boat.server.testing.ProcessClock;
import org.sami.boat.server.testing.TappedWire;
import org.sami.crw.proxy.tcp.LinkReport;
import org.sami.crw.sim.boat.TcpTestFleet.Base;

/** What a base is told, and counts, where it and a boat do not know each other, or one of them speaks plain. No clock counts. */
@Tag("long")
@Execution(ExecutionMode.CONCURRENT)
@Timeout(900)
class RefusedLinkTest {
    private static final long DAY_MS = 24 * 3_600_000;

    @TempDir
    private Path logs;

    private final TestLinks.Keys keys = TestLinks.withKeys();
    private final TestLinks.Keys others = TestLinks.withKeys();
    private TcpTestFleet fleet;
    private BoatOnTcp boat;

    @BeforeEach
    void open() throws Exception {
        fleet = new TcpTestFleet(logs, keys);
        boat = fleet.boat("anna");
    }

    @AfterEach
    void close() throws Exception {
        fleet.close();
    }

    private static LinkReport report(Base base) {
        return base.links().get(0);
    }

    /** The base says so, tries again, counts that, and knows no boat there. */
    private void assertTold(Base base, String words) throws Exception {
        Await.until(
                "the base says: " + words,
                () -> report(base).lastEvent().contains(words) && report(base).failedTries() >= 2);
        assertThat(report(base).boatId()).isEmpty();
        assertThat(base.heard).isEmpty();
        assertThat(base.failures).isEmpty();
        assertThat(fleet.log("anna")).isEmpty();
        Base own = fleet.base("own");
        own.connect(boat.address(), "anna");
    }

    private Fingerprint keyOfTheBoat() {
        return keys.boat("anna").identity().fingerprint();
    }

    @Test
    void boatWithAnotherKeyThanThePairedOneIsNamedByItsKey() throws Exception {
        Base base = fleet.base("stranger", others);
        base.tcp.connect(boat.address());

        assertTold(base, "its key " + keyOfTheBoat().shortText() + " is not paired with this base: crw keys pair ");
    }

    @Test
    void baseThatTheBoatDoesNotKnowIsToldSoByTheBoat() throws Exception {
        others.base.add(new Peer(keyOfTheBoat(), "anna", Role.OBSERVER));
        Base base = fleet.base("stranger", others);
        base.tcp.connect(boat.address());

        assertTold(base, "the boat turns this base away: this base is not paired with anna");
        Await.until("the boat counts it", () -> boat.refusedConnections() >= 2);
    }

    @Test
    void baseThatSpeaksPlainIsRefusedByABoatWithKeys() throws Exception {
        Base base = fleet.base("plain", TestLinks.plain());
        base.tcp.connect(boat.address());

        assertTold(base, "the boat takes only protected links: crw keys pair ");
        Await.until("the boat counts it", () -> boat.refusedConnections() >= 2);
    }

    @Test
    void boatThatSpeaksPlainIsRefusedByABaseWithKeys() throws Exception {
        try (TcpTestFleet plain = new TcpTestFleet(logs.resolve("plain"))) {
            BoatOnTcp open = plain.boat("berta");
            Base base = fleet.base("own");
            base.tcp.connect(open.address());

            assertTold(base, "no protected link");
            assertThat(plain.executedIds("berta")).isEmpty();
        }
    }

    /** What a certificate says anybody can repeat; that its key is there the handshake proves. */
    @Test
    void boatThatShowsAPairedCertificateWithoutItsKeyIsRefused() throws Exception {
        Identity pretended = new Identity(
                Identity.generate().key(), keys.boat("anna").identity().certificate());
        try (MalformedPeer thief = new MalformedPeer(
                new TlsLinks(pretended, key -> true),
                (connection, to) ->
                        to.write(LinkCodec.STANDARD.encode(0, new Welcome("anna", "boot", Role.COMMANDER, ""))))) {
            Base base = fleet.base("base");
            base.tcp.connect(thief.address());

            assertTold(base, "no protected link");
        }
    }

    /** The base's own clock says how old the recording is. */
    @ParameterizedTest
    @ValueSource(longs = {0, 61_000, DAY_MS})
    void whatABoatHasSaidBeforeIsRefusedWhenSomebodyPlaysItAgain(long ageMs) throws Exception {
        byte[] recorded;
        try (TappedWire wire = new TappedWire(boat.address(), TappedWire.UNCHANGED)) {
            Base watcher = fleet.base("watcher");
            watcher.tcp.connect(wire.address());
            watcher.linked("anna");
            recorded = wire.answered();
            watcher.close();
        }
        try (MalformedPeer player = new MalformedPeer((connection, to) -> to.write(recorded))) {
            Base base = fleet.base("base", () -> ProcessClock.ms() + ageMs);
            base.tcp.connect(player.address());

            assertTold(base, "no protected link");
        }
    }

    @Test
    void linkThatSomebodyBringsToAnOlderVersionIsNamedAndCountedAtBothEnds() throws Exception {
        try (TappedWire wire = new TappedWire(boat.address(), TappedWire.WITHOUT_VERSIONS)) {
            Base base = fleet.base("base");
            base.tcp.connect(wire.address());

            assertTold(base, "downgrade");
            Await.until("the boat counts it", () -> boat.refusedConnections() >= 2);
        }
    }

    @ParameterizedTest
    @ValueSource(longs = {-DAY_MS, DAY_MS})
    void clockOfTheBoatMayBeADayOff(long offMs) throws Exception {
        BoatOnTcp early = fleet.boat("berta", () -> ProcessClock.ms() + 2 * DAY_MS + offMs);
        Base base = fleet.base("base");

        base.connect(early.address(), "berta");
        base.submit("berta", TcpTestFleet.path("m1", 1, 4));

        Await.until("it is done", () -> base.count("berta completed m1") == 1);
        assertThat(early.refusedConnections()).isZero();
    }

    @ParameterizedTest
    @ValueSource(longs = {-DAY_MS, DAY_MS})
    void clockOfTheBaseMayBeADayOff(long offMs) throws Exception {
        Base base = fleet.base("base", () -> ProcessClock.ms() + 2 * DAY_MS + offMs);

        base.connect(boat.address(), "anna");
        base.submit("anna", TcpTestFleet.path("m1", 1, 4));

        Await.until("it is done", () -> base.count("anna completed m1") == 1);
        assertThat(boat.refusedConnections()).isZero();
    }
}
