package org.sami.crw.gui;

import static java.awt.event.KeyEvent.VK_ALT;
import static java.awt.event.KeyEvent.VK_ENTER;
import static java.awt.event.KeyEvent.VK_K;
import static java.awt.event.KeyEvent.VK_SHIFT;
import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Isolated;
import org.sami.boat.link.BoatMode;
import org.sami.boat.link.Role;
import org.sami.boat.link.SteadyClock;
import org.sami.boat.link.security.KeyRing;
import org.sami.boat.link.security.KeyStoreFolder;
import org.sami.boat.link.security.PairingResponder;
import org.sami.boat.link.security.Peer;
import org.sami.boat.server.tcp.TcpServerListener;
import org.sami.boat.server.testing.ProcessClock;
import org.sami.crw.operator.boat.BoatSnapshot;
import org.sami.crw.sim.boat.BoatOnTcp;
import org.sami.crw.sim.boat.BoatSettings;
import org.sami.spn.value.GeoPoint;
import org.sami.ui.check.RealDisplay;
import org.sami.ui.check.WindowRobot;

/** The keys of a fleet go from the window of one laptop to that of a second in one encrypted file; the second commands the boats then. */
@Tag("window")
@Timeout(900)
@Isolated("what --keys says holds for the whole process")
class FleetKeysWindowTest {
    private static final GeoPoint QUAY = GeoPoint.of(25.3597, 51.5268);
    private static final String PASSWORD = "in the boat house";

    @TempDir
    private Path folder;

    private final KeyRing boatKeys = KeyRing.inMemory();
    private BoatOnTcp boat;
    private WindowRobot robot;

    @BeforeEach
    void launchABoatThatIsPairedWithTheFirstLaptop() throws Exception {
        RealDisplay.assumed();
        KeyRing first = new KeyStoreFolder(KeyedWindow.keys(folder.resolve("first"))).open();
        first.add(new Peer(boatKeys.identity().fingerprint(), "olga", Role.OBSERVER));
        boatKeys.add(new Peer(first.identity().fingerprint(), "first laptop", Role.COMMANDER));
        boat = new BoatOnTcp(
                BoatSettings.of("olga", new InetSocketAddress(InetAddress.getLoopbackAddress(), 0), QUAY, 7),
                new SteadyClock(ProcessClock::ms),
                TcpServerListener.NONE,
                plain -> plain.withKeys(boatKeys, new PairingResponder(boatKeys)));
        robot = new WindowRobot();
    }

    @AfterEach
    void close() throws IOException {
        if (boat != null) {
            boat.close();
        }
    }

    private KeyedWindow open(String laptop) throws Exception {
        return new KeyedWindow(
                folder.resolve(laptop),
                "--connect",
                "127.0.0.1:" + boat.address().getPort());
    }

    private void openKeys() {
        robot.press(VK_K, VK_ALT, VK_SHIFT);
        robot.untilShown("keys-sheet");
    }

    private void answer(String button, String file, String... passwords) {
        robot.click(button);
        KeyedWindow.type(robot, "keys-file", file);
        KeyedWindow.type(robot, "keys-password", passwords[0]);
        if (passwords.length > 1) {
            KeyedWindow.type(robot, "keys-repeated", passwords[1]);
        }
        robot.press(VK_ENTER);
    }

    private void untilSaid(KeyedWindow laptop, String words) {
        robot.until(
                words,
                () -> SessionWorld.text(laptop.window.frame(), "keys-said").contains(words));
    }

    @Test
    void secondLaptopTakesTheKeysOfTheFirstAndCommandsItsBoat() throws Exception {
        Path file = folder.resolve("fleet.keys");
        try (KeyedWindow first = open("first")) {
            robot.untilSaid("boats-count", "1 of 1");
            openKeys();
            answer("keys-export", file.toString(), PASSWORD, "in another house");
            untilSaid(first, "the two passwords differ");
            assertThat(file).doesNotExist();
            answer("keys-export", file.toString(), PASSWORD, PASSWORD);
            untilSaid(first, "has this base's key and 1 boat");
        }
        assertThat(new String(Files.readAllBytes(file), StandardCharsets.ISO_8859_1))
                .doesNotContain("olga");

        try (KeyedWindow second = open("second")) {
            openKeys();
            robot.until(
                    "it knows no boat",
                    () -> SessionWorld.rows(second.window.frame(), "keys-table").isEmpty());
            answer("keys-import", file.toString(), "in another house");
            untilSaid(second, "the password is another one, or the file is damaged");
            assertThat(boat.refusedConnections())
                    .as("by the boat, of a laptop that it does not know")
                    .isPositive();

            answer("keys-import", file.toString(), PASSWORD);
            untilSaid(second, "and 1 boat now");
            robot.untilSaid("boats-count", "1 of 1");
            SessionWorld.get(second.window.session().fleet().stop("olga"));
            robot.until(
                    "the boat obeys",
                    () -> second.window
                            .session()
                            .models()
                            .fleet()
                            .boat("olga")
                            .flatMap(BoatSnapshot::mode)
                            .filter(BoatMode.STOPPED::equals)
                            .isPresent());
        }
        assertThat(boatKeys.peers()).extracting(Peer::name).containsExactly("first laptop");
    }
}
