package org.sami.crw.gui.mission;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.BorderLayout;
import java.awt.KeyboardFocusManager;
import java.nio.file.Path;
import java.util.Optional;
import javax.swing.JFrame;
import javax.swing.JTabbedPane;
import javax.swing.JTextField;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sami.crw.gui.SessionWorld;
import org.sami.crw.gui.context.LoadedProject;
import org.sami.spn.model.Project;
import org.sami.ui.check.RealDisplay;
import org.sami.ui.check.WindowRobot;
import org.sami.ui.window.WindowSettings;

/** Where the keyboard's focus is after missions began, here and elsewhere. */
@Tag("window")
@Timeout(900)
class MissionFocusWindowTest {
    private static final Project PROJECT = SessionWorld.project("""
            {'formatVersion': 1, 'id': 'lake', 'name': 'Lake', 'domain': 'crw',
             'globals': [{'name': '@spacing', 'type': 'real', 'initial': 5}],
             'missionTree': [{'label': 'All', 'children': [{'plan': 'waits'}]}],
             'plans': [
              {'id': 'waits', 'name': 'Waits', 'places': [{'id': 'stay', 'name': 'Stay', 'start': true}],
               'transitions': [], 'inEdges': [], 'outEdges': []}
             ]}""");

    @TempDir
    private Path folder;

    private String focused() {
        return WindowRobot.still(() -> String.valueOf(Optional.ofNullable(
                        KeyboardFocusManager.getCurrentKeyboardFocusManager().getFocusOwner())
                .map(owner -> owner.getName())
                .orElse("nothing")));
    }

    private static void focus(WindowRobot robot, String name) {
        robot.click(name);
        robot.untilFocused(name);
    }

    @Test
    void missionThatBeginsElsewhereTakesTheKeyboardFromNobodyWhoWrites() throws Exception {
        RealDisplay.assumed();
        try (SessionWorld world = new SessionWorld(PROJECT)) {
            JFrame frame = WindowRobot.ask(() -> {
                MissionMonitor monitor = new MissionMonitor(
                        world.context,
                        new MissionStarter(
                                world.context,
                                new WindowSettings(folder.resolve("settings")),
                                world.editors(),
                                values -> {}),
                        world.editors(),
                        new LoadedProject(Optional.empty()));
                JTextField elsewhere = new JTextField(20);
                elsewhere.setName("elsewhere");
                JFrame made = new JFrame("missions");
                made.add(monitor);
                made.add(elsewhere, BorderLayout.SOUTH);
                made.setSize(900, 600);
                made.setVisible(true);
                return made;
            });
            try {
                WindowRobot robot = new WindowRobot();
                JTabbedPane tabs = robot.find(JTabbedPane.class, "mission-tabs");

                focus(robot, "elsewhere");
                world.start("waits");
                robot.until("its tab is in front", () -> tabs.getSelectedIndex() == 3);
                assertThat(focused()).as("outside of the missions").isEqualTo("elsewhere");

                WindowRobot.ask(() -> {
                    tabs.setSelectedIndex(0);
                    return null;
                });
                focus(robot, "plans-search");
                world.start("waits");
                robot.until("it has a tab", () -> tabs.getTabCount() == 5);
                assertThat(focused()).as("where plans are searched").isEqualTo("plans-search");

                world.run("mission-start");
                robot.until("what was started here is in front", () -> tabs.getSelectedIndex() == 5);
                robot.untilFocused("mission-parts");

                world.run("mission-abort");
                robot.untilFocused("mission-end-confirm");
                world.start("waits");
                robot.until("it has a tab", () -> tabs.getTabCount() == 7);
                assertThat(focused()).as("where a mission is to be ended").isEqualTo("mission-end-confirm");
            } finally {
                WindowRobot.ask(() -> {
                    frame.dispose();
                    return null;
                });
            }
        }
    }
}
