package org.sami.crw.gui;

import static java.awt.event.KeyEvent.VK_ALT;
import static java.awt.event.KeyEvent.VK_C;
import static java.awt.event.KeyEvent.VK_CONTROL;
import static java.awt.event.KeyEvent.VK_ENTER;
import static java.awt.event.KeyEvent.VK_SHIFT;
import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Component;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.SwingUtilities;
import javax.swing.text.JTextComponent;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sami.crw.gui.window.OperatorWindow;
import org.sami.crw.operator.boat.BoatSnapshot;
import org.sami.crw.operator.mission.MissionSnapshot;
import org.sami.spn.protocol.Outcome;
import org.sami.spn.value.GeoPoint;
import org.sami.ui.check.Layout;
import org.sami.ui.check.RealDisplay;
import org.sami.ui.check.WindowRobot;
import org.sami.ui.geo.MapFrame;
import org.sami.ui.map.MapView;

/** A whole mission in the real window, by pointer and keys: the area and the boats are given as they are asked for. */
@Tag("window")
class ExploreWindowTest {
    private static final int THERE_WITHIN_S = 300;
    private static final double QUAY_LON_DEG = 51.5268;

    /** Some tens of metres of free water east of the boats. */
    private static final List<GeoPoint> CORNERS = List.of(
            GeoPoint.of(25.3601, 51.5273),
            GeoPoint.of(25.3601, 51.5281),
            GeoPoint.of(25.3593, 51.5281),
            GeoPoint.of(25.3593, 51.5273));

    @TempDir
    private Path folder;

    @Test
    void aDrawnAreaIsExploredByTheChosenBoatsUntilTheMissionIsCompleted() throws Exception {
        RealDisplay.assumed();
        try (OpenedWindow opened = OpenedWindow.onBuiltInFleet(folder)) {
            OperatorWindow window = opened.window();
            explore(new WindowRobot(), window);
        }
    }

    private static void explore(WindowRobot robot, OperatorWindow window) {
        robot.untilSaid("boats-count", "5 of 5");
        robot.clickRow("plans-table", "Explore Area with interrupts");
        robot.click("mission-start");

        Component map = robot.find(Component.class, "map-canvas");
        MapView view = WindowRobot.ask(() -> (MapView) SwingUtilities.getAncestorOfClass(MapView.class, map));
        robot.until("the pen is ready on the large map", view::isEditing);
        MapFrame frame = WindowRobot.ask(view::frame);
        clickAt(robot, map, frame, CORNERS);
        untilCosts(robot, window, "5 boats");
        robot.press(VK_ENTER); // leads back to the answer
        robot.untilFocused("decision-answer");
        ReadQuestion.await(robot);
        robot.press(VK_ENTER);

        robot.click("value-decision-none-chosen");
        robot.click("value-decision-option-1");
        untilCosts(robot, window, "anna: ");
        robot.until( // the map rests a moment after it was used
                "the pen is out for boats",
                () -> Layout.find(window.frame(), "decision-draw", JComponent.class)
                        .filter(Component::isShowing)
                        .isEmpty());
        clickAt(robot, map, frame, List.of(position(window, "bert")));
        robot.untilSaid("value-decision-count", "2 of 5");
        untilCosts(robot, window, "2 boats");
        ReadQuestion.await(robot);
        robot.press(VK_ENTER, VK_ALT);

        robot.until("two boats are under way", () -> underWay(window) == 2);
        assertThat(boats(window))
                .filteredOn(boat -> boat.points() > 0)
                .extracting(BoatSnapshot::boat)
                .containsExactlyInAnyOrder("anna", "bert");

        assertThat(window.session().models().clicks().clicks())
                .as("a start, four corners and two boats, each of the two answers with a click to confirm")
                .isEqualTo(1 + (4 + 1) + (2 + 1));

        robot.until("both sail towards the area", THERE_WITHIN_S, () -> sailing(window) == 2);
        robot.press(VK_C, VK_CONTROL, VK_SHIFT);
        robot.click("mission-end-confirm");

        robot.until("the mission is completed", () -> mission(window).outcome().equals(Optional.of(Outcome.COMPLETED)));
    }

    /** What it takes is said in the panel, in one line where the panel is low. */
    private static void untilCosts(WindowRobot robot, OperatorWindow window, String words) {
        robot.until(
                "it is said what it takes: " + words,
                () -> Stream.of("decision-costs", "decision-judgement-line")
                        .flatMap(name -> Layout.find(window.frame(), name, JComponent.class).stream())
                        .filter(Component::isShowing)
                        .map(said -> said instanceof JLabel line ? line.getText() : ((JTextComponent) said).getText())
                        .anyMatch(said -> said.contains(words)));
    }

    private static void clickAt(WindowRobot robot, Component map, MapFrame frame, List<GeoPoint> points) {
        points.forEach(point -> robot.clickAt(map, (int) frame.px(point), (int) frame.py(point)));
    }

    private static GeoPoint position(OperatorWindow window, String boat) {
        return window.session()
                .models()
                .fleet()
                .boat(boat)
                .orElseThrow()
                .pose()
                .orElseThrow()
                .position();
    }

    /** How many boats are some metres east of the quay, where the area is. */
    private static long sailing(OperatorWindow window) {
        return boats(window).stream()
                .filter(boat -> boat.pose().orElseThrow().position().lonDeg() > QUAY_LON_DEG + 0.00004)
                .count();
    }

    private static long underWay(OperatorWindow window) {
        return boats(window).stream().filter(boat -> boat.points() > 0).count();
    }

    private static List<BoatSnapshot> boats(OperatorWindow window) {
        return window.session().models().fleet().snapshot();
    }

    private static MissionSnapshot mission(OperatorWindow window) {
        return window.session().models().missions().snapshot().missions().get(0);
    }
}
