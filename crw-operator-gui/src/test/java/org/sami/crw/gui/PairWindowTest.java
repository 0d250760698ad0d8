package org.sami.crw.gui;

import static java.awt.event.KeyEvent.VK_ALT;
import static java.awt.event.KeyEvent.VK_ENTER;
import static java.awt.event.KeyEvent.VK_ESCAPE;
import static java.awt.event.KeyEvent.VK_K;
import static java.awt.event.KeyEvent.VK_P;
import static java.awt.event.KeyEvent.VK_SHIFT;
import static java.awt.event.KeyEvent.VK_SPACE;
import static java.awt.event.KeyEvent.VK_TAB;
import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import javax.swing.JLabel;
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
import org.sami.boat.link.security.Fingerprint;
import org.sami.boat.link.security.KeyRing;
import org.sami.boat.link.security.KeyStoreFolder;
import org.sami.boat.link.security.PairingResponder;
import org.sami.boat.link.security.PairingSecret;
import org.sami.boat.link.security.Peer;
import org.sami.boat.server.tcp.TcpServerListener;
import org.sami.boat.server.testing.ProcessClock;
import org.sami.crw.gui.window.OperatorWindow;
import org.sami.crw.operator.boat.BoatSnapshot;
import org.sami.crw.sim.boat.BoatOnTcp;
import org.sami.crw.sim.boat.BoatSettings;
import org.sami.spn.value.GeoPoint;
import org.sami.ui.check.RealDisplay;
import org.sami.ui.check.WindowRobot;
import org.sami.ui.sheet.WindowSheet;

/** A boat with keys is paired in the window that was started with --keys, by keys of the keyboard alone, and commanded then; a withdrawn key is carried to it. */
@Tag("window")
@Timeout(900)
@Isolated("what --keys says holds for the whole process")
class PairWindowTest {
    private static final GeoPoint QUAY = GeoPoint.of(25.3597, 51.5268);

    @TempDir
    private Path folder;

    private final SteadyClock clock = new SteadyClock(ProcessClock::ms);
    private final List<String> codes = new CopyOnWriteArrayList<>();
    private final KeyRing boatKeys = KeyRing.inMemory();
    private final PairingResponder responder = new PairingResponder(boatKeys, (base, code) -> codes.add(code));
    private BoatOnTcp boat;
    private WindowRobot robot;
    private KeyedWindow laptop;
    private OperatorWindow window;

    @BeforeEach
    void open() throws Exception {
        RealDisplay.assumed();
        boat = new BoatOnTcp(
                BoatSettings.of("olga", new InetSocketAddress(InetAddress.getLoopbackAddress(), 0), QUAY, 7),
                clock,
                TcpServerListener.NONE,
                plain -> plain.withKeys(boatKeys, responder));
        robot = new WindowRobot();
        laptop = new KeyedWindow(folder);
        window = laptop.window;
        robot.untilSaid("boats-count", "5 of 5"); // the window's own simulated boats stay plain
    }

    @AfterEach
    void close() throws Exception {
        if (laptop != null) {
            laptop.close();
        }
        if (boat != null) {
            boat.close();
        }
    }

    private Fingerprint ownKey() throws IOException {
        return new KeyStoreFolder(KeyedWindow.keys(folder)).open().identity().fingerprint();
    }

    private void type(String field, String text) {
        KeyedWindow.type(robot, field, text);
    }

    @Test
    void boatIsPairedByKeysAloneAndCommandedAndAWithdrawnKeyIsCarriedToIt() throws Exception {
        PairingSecret words = responder.open(Role.COMMANDER, clock.getAsLong());
        robot.press(VK_P, VK_ALT, VK_SHIFT);
        robot.untilShown("pair-sheet");
        type("pair-address", "127.0.0.1:" + boat.address().getPort());
        type("pair-words", PairingSecret.random().toString());
        robot.press(VK_ENTER);
        robot.until("wrong words are named", () -> judged().contains("the words are not those that the boat shows"));
        assertThat(judged()).startsWith("▲ Not paired: olga").contains("4 tries are left");
        assertThat(boatKeys.peers()).isEmpty();

        type("pair-words", words.toString());
        robot.press(VK_ENTER);
        robot.untilFocused("pair-same");
        robot.until(
                "both sides show the same code",
                () -> codes.contains(robot.find(JLabel.class, "pair-code").getText()));
        robot.until("the whole code is in sight", () -> {
            JLabel code = robot.find(JLabel.class, "pair-code");
            return code.getVisibleRect().height == code.getHeight() && code.getHeight() > 0;
        });
        robot.press(VK_SPACE);
        robot.until("it is paired", () -> judged().startsWith("✓ Paired with olga: this base may command it"));
        robot.untilFocused("pair-connect");
        robot.press(VK_SPACE);
        robot.untilSaid("boats-count", "6 of 6");
        robot.press(VK_ESCAPE);

        SessionWorld.get(window.session().fleet().stop("olga"));
        robot.until(
                "the boat obeys",
                () -> window.session()
                        .models()
                        .fleet()
                        .boat("olga")
                        .flatMap(BoatSnapshot::mode)
                        .filter(BoatMode.FLEET_STOP::equals)
                        .isPresent());

        KeyRing lost = KeyRing.inMemory();
        Fingerprint laptop = lost.identity().fingerprint();
        boatKeys.add(new Peer(laptop, "lost laptop", Role.COMMANDER));
        robot.press(VK_K, VK_ALT, VK_SHIFT);
        robot.untilShown("keys-sheet");
        robot.until(
                "the boat is listed",
                () -> SessionWorld.rows(window.frame(), "keys-table").contains("olga|command|linked now|"));
        robot.click("keys-lost");
        type("keys-key", laptop.toString());
        robot.press(VK_ENTER);
        robot.until("the boat has learnt it", () -> boatKeys.isWithdrawn(laptop));
        assertThat(boatKeys.find(ownKey())).isPresent();
    }

    @Test
    void wrongWordIsNamedWhileItIsTypedAndEscapeLeavesAllAsItIs() throws Exception {
        responder.open(Role.COMMANDER, clock.getAsLong());
        robot.press(VK_P, VK_ALT, VK_SHIFT);
        robot.untilShown("pair-sheet");
        type("pair-address", "127.0.0.1:" + boat.address().getPort());
        type("pair-words", "xy ");
        robot.until("the wrong word is named", () -> judged().contains("'xy' is none of the words that a boat shows"));
        robot.press(VK_TAB);
        robot.untilFocused("pair-role");
        robot.press(VK_ESCAPE);
        robot.until("the sheet is closed", () -> !isShown("pair-sheet"));
        assertThat(boatKeys.peers()).isEmpty();
    }

    private boolean isShown(String sheet) {
        return WindowSheet.find(window.frame().getRootPane())
                .filter(one -> one.name().equals(sheet))
                .isPresent();
    }

    private String judged() {
        return SessionWorld.text(window.frame(), "pair-judged");
    }
}
