package org.sami.crw.gui.boat;

import static org.assertj.core.api.Assertions.assertThat;
import static org.sami.crw.gui.EventThreadCall.onEventThread;

import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import javax.swing.AbstractButton;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.sami.crw.gui.SessionWorld;
import org.sami.crw.proxy.tcp.BoatAddress;
import org.sami.crw.sim.boat.SimulatedBoatsOnTcp;
import org.sami.ui.check.Layout;
import org.sami.ui.check.TextFit;

/** What Ctrl+B says of an address, in a session that has no boat yet. */
@Timeout(900)
class ConnectFormTest {
    private static void until(ConnectForm form, String words) {
        SessionWorld.until("\"" + words + "\" is said", () -> {
            form.refresh();
            return SessionWorld.text(form, "boat-connect-said").contains(words);
        });
    }

    private static boolean isSeen(ConnectForm form, String name) {
        return onEventThread(
                () -> SessionWorld.find(form, name, AbstractButton.class).isVisible());
    }

    @Test
    void theBoatThatAnswersIsNamedAndTheNextAddressCanBeTyped() throws Exception {
        try (SessionWorld world = new SessionWorld(SessionWorld.library("clv"))) {
            BoatAddress anna = new SimulatedBoatsOnTcp(1).launch("anna", SessionWorld.PIER);
            ConnectForm form = SessionWorld.laidOut(() -> new ConnectForm(world.context));
            assertThat(SessionWorld.text(form, "boat-connect-said")).startsWith("Type the address");

            SessionWorld.type(form, "boat-connect-address", anna.toString());
            SessionWorld.press(form, "boat-connect-do");

            until(form, "✓ " + anna + " is connected as anna");
            assertThat(SessionWorld.text(form, "boat-connect-address")).isEmpty();
            assertThat(isSeen(form, "boat-connect-give-up")).isFalse();
            SessionWorld.type(form, "boat-connect-address", "10.0.0.9");
            assertThat(SessionWorld.text(form, "boat-connect-said")).startsWith("'10.0.0.9' is no HOST:PORT");
        }
    }

    @Test
    void inASmallWindowTheWordsAreSeenWholeAndTheButtonIsReached() throws Exception {
        try (SessionWorld world = new SessionWorld(SessionWorld.library("clv"))) {
            ConnectForm form = SessionWorld.laidOut(() -> new ConnectForm(world.context));

            onEventThread(() -> {
                Layout.layOut(form, 700, 260);
                assertThat(TextFit.faults(form)).isEmpty();
                assertThat(Layout.find(form, "boat-connect-do", AbstractButton.class)
                                .orElseThrow()
                                .getBounds()
                                .getMaxX())
                        .isLessThan(700);
                return null;
            });
        }
    }

    @Test
    void whereNobodyAnswersItIsSaidWhyUntilTheAddressIsGivenUp() throws Exception {
        try (SessionWorld world = new SessionWorld(SessionWorld.library("clv"))) {
            BoatAddress nobody = deaf();
            ConnectForm form = SessionWorld.laidOut(() -> new ConnectForm(world.context));

            SessionWorld.type(form, "boat-connect-address", nobody.toString());
            SessionWorld.press(form, "boat-connect-do");

            until(form, "▲ " + nobody + " does not answer (connection refused, tried ");
            SessionWorld.press(form, "boat-connect-give-up");
            SessionWorld.until(
                    "nobody tries it any longer",
                    () -> world.context.models().unreached().snapshot().isEmpty());
            until(form, "Type the address");
        }
    }

    @Test
    void severalAddressesAreConnectedAsByTheOptionAndEachHasItsLine() throws Exception {
        try (SessionWorld world = new SessionWorld(SessionWorld.library("clv"))) {
            BoatAddress anna = new SimulatedBoatsOnTcp(1).launch("anna", SessionWorld.PIER);
            BoatAddress nobody = deaf();
            ConnectForm form = SessionWorld.laidOut(() -> new ConnectForm(world.context));

            SessionWorld.type(form, "boat-connect-address", anna + ", " + nobody);
            SessionWorld.press(form, "boat-connect-do");

            until(form, "✓ " + anna + " is connected as anna\n▲ " + nobody + " does not answer");
            SessionWorld.press(form, "boat-connect-give-up");
            until(form, "✓ " + anna + " is connected as anna");
            SessionWorld.until(
                    "nobody tries it any longer",
                    () -> world.context.models().unreached().snapshot().isEmpty());
        }
    }

    @Test
    void vehiclesOfALinkMayBeNamedByTheirNumbers() throws Exception {
        try (SessionWorld world = new SessionWorld(SessionWorld.library("clv"))) {
            ConnectForm form = SessionWorld.laidOut(() -> new ConnectForm(world.context));

            SessionWorld.type(form, "boat-connect-address", "mavlink:udp:14550/21-25");
            assertThat(SessionWorld.text(form, "boat-connect-said")).isEmpty();

            SessionWorld.type(form, "boat-connect-address", "mavlink:udp:14550/25-21");
            assertThat(SessionWorld.text(form, "boat-connect-said"))
                    .startsWith("'mavlink:udp:14550/25-21' is no MAVLink address: the first system id, 25, is above");
        }
    }

    private static BoatAddress deaf() throws IOException {
        try (ServerSocket taken = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
            return new BoatAddress("127.0.0.1", taken.getLocalPort()); // closed again: nobody listens there
        }
    }
}
