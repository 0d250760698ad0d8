package org.sami.crw.gui;

import static java.awt.event.KeyEvent.VK_ALT;
import static java.awt.event.KeyEvent.VK_CONTROL;
import static java.awt.event.KeyEvent.VK_ENTER;
import static java.awt.event.KeyEvent.VK_ESCAPE;
import static java.awt.event.KeyEvent.VK_N;
import static java.awt.event.KeyEvent.VK_SPACE;
import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Component;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.SwingUtilities;
import javax.swing.text.JTextComponent;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Isolated;
import org.sami.boat.server.testing.Await;
import org.sami.crw.gui.window.OperatorWindow;
import org.sami.crw.proxy.tcp.BaseProtection;
import org.sami.spn.value.GeoPoint;
import org.sami.ui.check.Layout;
import org.sami.ui.check.RealDisplay;
import org.sami.ui.check.WindowRobot;
import org.sami.ui.geo.MapFrame;
import org.sami.ui.map.MapView;

/** Twenty boats that announce themselves are found, connected, checked and put in a mission; the presses are those that docs/clicks.md says. */
@Tag("window")
@Timeout(900)
@Isolated("what --keys says holds for the whole process")
class NearWindowTest {
    private static final int BOATS = 20;
    private static final int WITHIN_S = 300;
    private static final String STRANGER = "stranger";
    private static final List<String> NAMES =
            IntStream.rangeClosed(1, BOATS).mapToObj(number -> "boat" + number).toList();

    /** Free water east of the boats. */
    private static final List<GeoPoint> CORNERS = List.of(
            GeoPoint.of(25.3602, 51.5279),
            GeoPoint.of(25.3602, 51.5295),
            GeoPoint.of(25.3588, 51.5295),
            GeoPoint.of(25.3588, 51.5279));

    @TempDir
    private Path folder;

    private OpenedWindow opened;
    private AnnouncedFleet fleet;
    private WindowRobot robot;
    private OperatorWindow window;
    private int keys;
    private int clicks;

    @BeforeEach
    void open() throws Exception {
        RealDisplay.assumed();
        List<String> all = Stream.concat(NAMES.stream(), Stream.of(STRANGER)).toList();
        fleet = new AnnouncedFleet(all, folder.resolve("keys"), STRANGER);
        robot = new WindowRobot();
        opened = OpenedWindow.byCommand(List.of(
                "--near",
                "--network",
                "127.0.0.1",
                "--keys",
                folder.resolve("keys").toString(),
                "--data",
                folder.resolve("data").toString(),
                "--no-resume"));
        window = opened.window();
    }

    @AfterEach
    void close() throws Exception {
        new BaseProtection(Optional.empty(), false).use();
        if (opened != null) {
            opened.end();
        }
        if (fleet != null) {
            fleet.close();
        }
    }

    @Test
    void twentyBoatsAreFoundConnectedCheckedAndPutInAMissionWithTenPresses() {
        robot.until(
                "all are found",
                WITHIN_S,
                () -> rows().stream()
                                        .filter(row -> row.endsWith("|80 %|paired|"))
                                        .count()
                                == BOATS
                        && rows().stream().anyMatch(row -> row.startsWith(STRANGER)));
        assertThat(rows()).anyMatch(row -> row.startsWith(STRANGER + "|") && row.contains("|not paired|have it show"));
        robot.untilFocused("near-connect-all");
        key(VK_SPACE);
        robot.until("all are ready", WITHIN_S, () -> count().contains("20 connected · 20 ready"));
        robot.until(
                "it is said who is not connected",
                () -> said().matches(
                                "20 of 20 connected\\. Not connected: .*\\b" + STRANGER + "\\b.* \\(not paired\\).*"));
        key(VK_ESCAPE);
        Await.until("nobody looks for boats any longer", () -> !isLooking());

        robot.untilSaid("boats-count", "20 of 20");
        click(robot.find(Component.class, "mission-start")); // the plan that explores is offered
        Component map = robot.find(Component.class, "map-canvas");
        MapView view = WindowRobot.ask(() -> (MapView) SwingUtilities.getAncestorOfClass(MapView.class, map));
        robot.until("the pen is ready on the large map", view::isEditing);
        MapFrame frame = WindowRobot.ask(view::frame);
        for (GeoPoint corner : CORNERS) {
            robot.clickAt(map, (int) frame.px(corner), (int) frame.py(corner));
            clicks++;
        }
        untilCosts("20 boats");
        key(VK_ENTER); // leads back to the answer
        robot.untilFocused("decision-answer");
        ReadQuestion.await(robot);
        key(VK_ENTER);
        robot.untilSaid("value-decision-count", "20 of 20"); // all are offered
        untilCosts("20 boats");
        ReadQuestion.await(robot);
        key(VK_ENTER, VK_ALT);

        robot.until("twenty boats are under way", WITHIN_S, () -> underWay() == BOATS);
        assertThat(clicks).as("clicks").isEqualTo(5);
        assertThat(keys).as("keys").isEqualTo(5);
    }

    @Test
    void listThatIsClosedGivesTheFocusBackAndIsOpenedByItsKey() {
        robot.until("it is open at first", () -> !rows().isEmpty());
        key(VK_ESCAPE);
        robot.until(
                "it is closed",
                () -> Layout.find(window.frame(), "boats-near-table", JComponent.class)
                        .isEmpty());
        Component before = robot.find(Component.class, "plans-table");
        robot.clickRow("plans-table", "Explore Area with interrupts");
        robot.untilFocused("plans-table");
        key(VK_N, VK_CONTROL);
        robot.untilFocused("near-connect-all");
        key(VK_ESCAPE);
        robot.until("the focus is where it was", before::isFocusOwner);
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

    private List<String> rows() {
        return Layout.find(window.frame(), "boats-near-table", JComponent.class).isEmpty()
                ? List.of()
                : SessionWorld.rows(window.frame(), "boats-near-table").lines().toList();
    }

    private String count() {
        return SessionWorld.text(window.frame(), "boats-near-count");
    }

    private String said() {
        return SessionWorld.text(window.frame(), "boats-near-said");
    }

    private static boolean isLooking() {
        return Thread.getAllStackTraces().keySet().stream()
                .anyMatch(thread -> thread.getName().equals("boats near"));
    }

    private long underWay() {
        return window.session().models().fleet().snapshot().stream()
                .filter(boat -> boat.points() > 0)
                .count();
    }

    /** What it takes is said in the panel, in one line where the panel is low. */
    private void untilCosts(String words) {
        robot.until(
                "it is said what it takes: " + words,
                () -> Stream.of("decision-costs", "decision-judgement-line")
                        .flatMap(name -> Layout.find(window.frame(), name, JComponent.class).stream())
                        .filter(Component::isShowing)
                        .map(said -> said instanceof JLabel line ? line.getText() : ((JTextComponent) said).getText())
                        .anyMatch(said -> said.contains(words)));
    }
}
