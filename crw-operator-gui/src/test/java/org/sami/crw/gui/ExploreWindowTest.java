package org.sami.crw.gui;

import static java.awt.event.KeyEvent.VK_ALT;
import static java.awt.event.KeyEvent.VK_D;
import static java.awt.event.KeyEvent.VK_ENTER;
import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeFalse;

import java.awt.Component;
import java.awt.GraphicsEnvironment;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import javax.swing.SwingUtilities;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sami.crw.gui.start.DataDirectory;
import org.sami.crw.gui.start.StartOptions;
import org.sami.crw.gui.window.OperatorWindow;
import org.sami.crw.operator.boat.BoatSnapshot;
import org.sami.crw.operator.mission.MissionSnapshot;
import org.sami.spn.protocol.Outcome;
import org.sami.spn.value.GeoPoint;
import org.sami.ui.check.WindowRobot;
import org.sami.ui.geo.MapFrame;
import org.sami.ui.look.Theme;
import org.sami.ui.map.MapView;

/** A whole mission in the real window, by pointer and keys: the area and the boats are given as they are asked for. */
@Tag("window")
class ExploreWindowTest {
    private static final int THERE_WITHIN_S = 60;
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
        assumeFalse(
                GraphicsEnvironment.isHeadless(),
                () -> "there is no display; get one by: " + System.getProperty("window.install"));
        CompletableFuture<Integer> ended = new CompletableFuture<>();
        StartOptions options = new StartOptions(
                List.of(), Optional.empty(), Optional.of(Theme.LIGHT), Optional.of(100), Optional.of(false));
        OperatorWindow window = WindowStart.open(options, DataDirectory.open(folder), ended::complete);
        try {
            explore(new WindowRobot(), window);
        } finally {
            WindowRobot.ask(() -> {
                window.end();
                return null;
            });
            ended.get(60, TimeUnit.SECONDS);
        }
    }

    private static void explore(WindowRobot robot, OperatorWindow window) {
        robot.untilSaid("boats-count", "5 of 5");
        robot.clickRow("plans-table", "Explore Area with interrupts");
        robot.click("mission-start");

        robot.untilShown("value-area-canvas");
        robot.press(VK_D, VK_ALT); // on the large map; Enter there leads back to the answer
        robot.untilFocused("map-canvas");
        Component map = robot.find(Component.class, "map-canvas");
        MapView view = WindowRobot.ask(() -> (MapView) SwingUtilities.getAncestorOfClass(MapView.class, map));
        MapFrame frame = WindowRobot.ask(view::frame);
        for (GeoPoint corner : CORNERS) {
            robot.clickAt(map, (int) frame.px(corner), (int) frame.py(corner));
        }
        robot.press(VK_ENTER);
        robot.untilFocused("decision-answer");
        robot.press(VK_ENTER);

        robot.click("value-decision-none-chosen");
        robot.click("value-decision-option-1");
        robot.click("value-decision-option-2");
        robot.press(VK_ENTER, VK_ALT);

        robot.until("two boats are under way", () -> underWay(window) == 2);
        assertThat(boats(window))
                .filteredOn(boat -> boat.points() > 0)
                .extracting(BoatSnapshot::boat)
                .containsExactlyInAnyOrder("anna", "bert");

        robot.until("both sail towards the area", THERE_WITHIN_S, () -> sailing(window) == 2);
        robot.click("mission-complete");
        robot.click("mission-end-confirm");

        robot.untilSaid("mission-state", "completed");
        assertThat(mission(window).outcome()).contains(Outcome.COMPLETED);
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
