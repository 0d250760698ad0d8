package org.sami.crw.gui;

import static java.awt.event.KeyEvent.VK_ALT;
import static java.awt.event.KeyEvent.VK_B;
import static java.awt.event.KeyEvent.VK_CONTROL;
import static java.awt.event.KeyEvent.VK_ENTER;
import static java.awt.event.KeyEvent.VK_ESCAPE;
import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Component;
import java.io.InputStream;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import javax.swing.JComponent;
import javax.swing.SwingUtilities;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sami.crw.gui.window.OperatorWindow;
import org.sami.crw.operator.boat.BoatSnapshot;
import org.sami.mavlink.testing.SmallBoat;
import org.sami.mavlink.testing.UdpSenders;
import org.sami.spn.value.GeoPoint;
import org.sami.ui.check.Layout;
import org.sami.ui.check.RealDisplay;
import org.sami.ui.check.WindowRobot;
import org.sami.ui.geo.MapFrame;
import org.sami.ui.map.MapView;

/** Five boats of other makers are connected by their one address and sent to locations; the presses are those that docs/clicks.md says. */
@Tag("window")
@Timeout(900)
class AddressWindowTest {
    private static final int BOATS = 5;
    private static final int FIRST = 21;
    private static final int WITHIN_S = 300;
    private static final int AWAY_PX = 60;
    private static final double LAT_DEG = 25.3595;
    private static final double LON_DEG = 51.5283;
    private static final double APART_DEG = 0.0002;
    private static final Pattern PRESSES =
            Pattern.compile("sent to locations with \\*\\*(\\d+) presses: (\\w+) clicks and (\\w+) keys\\*\\*");
    private static final Map<String, Integer> NUMBERS = Map.of("five", 5, "six", 6, "seven", 7, "eight", 8, "nine", 9);

    @TempDir
    private Path folder;

    private final WindowRobot robot = new WindowRobot();
    private final List<SmallBoat> boats = new ArrayList<>();
    private OpenedWindow opened;
    private OperatorWindow window;
    private UdpSenders senders;
    private String address;
    private int keys;
    private int clicks;

    @BeforeEach
    void open() throws Exception {
        RealDisplay.assumed();
        int port = freePort();
        address = "mavlink:udp:" + port;
        senders = new UdpSenders(port);
        for (int i = 0; i < BOATS; i++) {
            SmallBoat boat = new SmallBoat(FIRST + i, LAT_DEG, LON_DEG + i * APART_DEG, 1);
            boats.add(boat);
            senders.add(boat);
        }
        Path plan = folder.resolve("clv.json");
        try (InputStream text = getClass().getResourceAsStream("/org/sami/domain/crw/plans/clv.json")) {
            Files.copy(text, plan);
        }
        opened = OpenedWindow.byCommand(List.of(
                "--near",
                "--network",
                "127.0.0.1",
                "--keys",
                folder.resolve("keys").toString(),
                "--project",
                plan.toString(),
                "--data",
                folder.resolve("data").toString(),
                "--no-resume"));
        window = opened.window();
        robot.until(
                "the list of boats near is there",
                () -> Layout.find(window.frame(), "boats-near-table", JComponent.class)
                        .isPresent());
        robot.press(VK_ESCAPE); // these boats do not announce themselves
    }

    private static int freePort() throws Exception {
        try (DatagramSocket free = new DatagramSocket(new InetSocketAddress(InetAddress.getLoopbackAddress(), 0))) {
            return free.getLocalPort();
        }
    }

    @AfterEach
    void close() throws Exception {
        if (opened != null) {
            opened.end();
        }
        if (senders != null) {
            senders.close();
        }
        for (SmallBoat boat : boats) {
            boat.close();
        }
    }

    @Test
    void fiveVehiclesAtOneAddressAreCheckedAndSentToLocationsWithThePressesThatAreDocumented() throws Exception {
        robot.until(
                "it is closed",
                () -> Layout.find(window.frame(), "boats-near-table", JComponent.class)
                        .isEmpty());
        key(VK_B, VK_CONTROL);
        robot.untilFocused("boat-connect-address");
        robot.type(address);
        key(VK_ENTER);
        robot.until(
                "it is said who is connected",
                WITHIN_S,
                () -> SessionWorld.text(window.frame(), "boat-connect-said")
                        .contains("is connected as mav21, mav22, mav23, mav24, mav25"));
        key(VK_ESCAPE);
        robot.untilSaid("boats-count", "5 of 5");
        robot.until(
                "all are listed with their charge",
                () -> SessionWorld.rows(window.frame(), "boats-table")
                                .lines()
                                .filter(row -> row.startsWith("mav2") && row.contains("87 %"))
                                .count()
                        == BOATS);

        click(robot.find(Component.class, "mission-start"));
        robot.untilSaid("value-decision-count", "5 of 5");
        ReadQuestion.await(robot);
        key(VK_ENTER, VK_ALT);
        markLocations();
        key(VK_ENTER); // leads back to the answer
        robot.untilFocused("decision-answer");
        ReadQuestion.await(robot);
        key(VK_ENTER);
        click(robot.find(Component.class, "value-decision-option-1"));
        ReadQuestion.await(robot);
        key(VK_ENTER, VK_ALT);

        robot.until(
                "each drives",
                WITHIN_S,
                () -> boats.stream().allMatch(SmallBoat::isArmed)
                        && fleet().stream().allMatch(boat -> boat.points() > 0));
        MatchResult said = documented();
        assertThat(clicks).as("clicks").isEqualTo(NUMBERS.get(said.group(2)));
        assertThat(keys).as("keys").isEqualTo(NUMBERS.get(said.group(3)));
        assertThat(clicks + keys).as("presses").isEqualTo(Integer.parseInt(said.group(1)));
    }

    private static MatchResult documented() throws Exception {
        return PRESSES.matcher(Files.readString(Path.of("..", "docs", "clicks.md")))
                .results()
                .findFirst()
                .orElseThrow();
    }

    private List<BoatSnapshot> fleet() {
        return window.session().models().fleet().snapshot();
    }

    /** One before each boat. */
    private void markLocations() {
        Component map = robot.find(Component.class, "map-canvas");
        MapView view = WindowRobot.ask(() -> (MapView) SwingUtilities.getAncestorOfClass(MapView.class, map));
        robot.until("the pen is ready on the large map", view::isEditing);
        MapFrame frame = WindowRobot.ask(view::frame);
        for (int i = 0; i < BOATS; i++) {
            GeoPoint at = GeoPoint.of(LAT_DEG, LON_DEG + i * APART_DEG);
            robot.clickAt(map, (int) frame.px(at), (int) frame.py(at) - AWAY_PX);
            clicks++;
        }
    }

    private void key(int key, int... held) {
        robot.press(key, held);
        keys++;
    }

    private void click(Component component) {
        robot.until(component.getName() + " can be pressed", component::isEnabled);
        robot.click(component);
        clicks++;
    }
}
