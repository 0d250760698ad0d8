package org.sami.crw.gui;

import static java.awt.event.KeyEvent.VK_3;
import static java.awt.event.KeyEvent.VK_8;
import static java.awt.event.KeyEvent.VK_ALT;
import static java.awt.event.KeyEvent.VK_C;
import static java.awt.event.KeyEvent.VK_CONTROL;
import static java.awt.event.KeyEvent.VK_D;
import static java.awt.event.KeyEvent.VK_E;
import static java.awt.event.KeyEvent.VK_ENTER;
import static java.awt.event.KeyEvent.VK_SHIFT;
import static java.awt.event.KeyEvent.VK_SPACE;
import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Component;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sami.crw.gui.start.StartOptions;
import org.sami.crw.gui.window.OperatorWindow;
import org.sami.crw.operator.boat.BoatSnapshot;
import org.sami.crw.operator.mission.MissionSnapshot;
import org.sami.crw.proxy.status.LinkState;
import org.sami.palette.Theme;
import org.sami.spn.protocol.Outcome;
import org.sami.ui.check.RealDisplay;
import org.sami.ui.check.WindowRobot;

/** A mission with boats that are processes, by keys alone: drawn, interrupted, with a boat's server killed and started again, completed. */
@Tag("window")
class KeyboardWindowTest {
    private static final List<String> CORNERS =
            List.of("25.3596, 51.5272", "25.3599, 51.5272", "25.3599, 51.5275", "25.3596, 51.5275");

    @TempDir
    private Path folder;

    @Test
    void aMissionIsRunByKeysAloneWhileABoatsServerIsKilledAndComesBack() throws Exception {
        RealDisplay.assumed();
        try (BoatServer anna = new BoatServer("anna", "25.3597,51.5268", folder);
                BoatServer bert = new BoatServer("bert", "25.3595,51.5268", folder);
                BoatServer carl = new BoatServer("carl", "25.3593,51.5268", folder)) {
            StartOptions options = new StartOptions(
                    List.of(anna.address(), bert.address(), carl.address()),
                    Optional.empty(),
                    Optional.of(Theme.LIGHT),
                    Optional.of(100),
                    Optional.of(false));
            try (OpenedWindow opened = OpenedWindow.open(options, folder.resolve("data"))) {
                OperatorWindow window = opened.window();
                WindowRobot robot = new WindowRobot();
                robot.untilSaid("boats-count", "3 of 3");
                explore(robot, window);
                loseAndFind(robot, window, carl);
                robot.press(VK_C, VK_CONTROL, VK_SHIFT);
                robot.untilShown("mission-ending");
                robot.press(VK_E, VK_CONTROL, VK_SHIFT);
                robot.until(
                        "the mission is completed",
                        () -> missions(window).get(0).outcome().equals(Optional.of(Outcome.COMPLETED)));
            }
            for (BoatServer boat : List.of(anna, bert)) {
                assertThat(boat.log())
                        .containsSubsequence(
                                "\"type\":\"upload\"", // its share of the area
                                "m1-",
                                "\"type\":\"upload\"", // the way to the safe place, of the sub-mission that the
                                // interrupt began
                                "m2-",
                                "\"type\":\"stop\"");
            }
            assertThat(carl.log()).doesNotContain("upload").doesNotContain("start");
        }
    }

    private static void explore(WindowRobot robot, OperatorWindow window) {
        robot.press(VK_ENTER, VK_CONTROL);
        robot.untilShown("value-area-text");
        robot.press(VK_D, VK_CONTROL);
        robot.untilFocused("value-area-text"); // the map next to it is left out: the large one has the pen
        for (String corner : CORNERS) {
            robot.type(corner);
            robot.press(VK_ENTER);
        }
        ReadQuestion.await(robot);
        robot.press(VK_ENTER, VK_ALT);

        robot.untilShown("value-decision-option-3");
        robot.press(VK_D, VK_CONTROL);
        robot.press(VK_3); // all are proposed
        robot.untilSaid("value-decision-count", "2 of 3");
        ReadQuestion.await(robot);
        robot.press(VK_ENTER, VK_ALT);
        robot.until(
                "two boats are under way",
                () -> boats(window).stream().filter(boat -> boat.points() > 0).count() == 2);
        robot.untilFocused("decisions"); // nothing waits: the next key is not the fleet stop's

        Component avoid = robot.find(Component.class, "interrupt-team-avoid-boat");
        robot.until("it can be pressed", avoid::isEnabled);
        robot.press(VK_8, VK_ALT);
        robot.untilFocused("interrupt-team-avoid-boat");
        robot.press(VK_SPACE);
        robot.untilSaid("decisions-count", "1 decision");
        ReadQuestion.await(robot);
        robot.press(VK_ENTER, VK_ALT);
        robot.until("the vessel is avoided", () -> missions(window).size() == 2);
    }

    /** A boat that is told nothing by the mission: its server is killed, is lost, and comes back. */
    private static void loseAndFind(WindowRobot robot, OperatorWindow window, BoatServer carl) throws Exception {
        carl.kill();
        robot.untilSaid("links-count", "1 link lost");
        robot.until("it is carl's", () -> boat(window, "carl").link() == LinkState.LOST);

        carl.start();
        robot.untilSaid("boats-count", "3 of 3");
        robot.until("carl is linked", () -> boat(window, "carl").link() == LinkState.LINKED);
    }

    private static List<BoatSnapshot> boats(OperatorWindow window) {
        return window.session().models().fleet().snapshot();
    }

    private static BoatSnapshot boat(OperatorWindow window, String name) {
        return window.session().models().fleet().boat(name).orElseThrow();
    }

    private static List<MissionSnapshot> missions(OperatorWindow window) {
        return window.session().models().missions().snapshot().missions();
    }
}
