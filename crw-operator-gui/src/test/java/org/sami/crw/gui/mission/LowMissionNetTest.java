package org.sami.crw.gui.mission;

import static org.assertj.core.api.Assertions.assertThat;
import static org.sami.crw.gui.EventThreadCall.onEventThread;
import static org.sami.crw.gui.SessionWorld.find;
import static org.sami.crw.gui.SessionWorld.until;

import java.nio.file.Path;
import java.util.Optional;
import javax.swing.JComboBox;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Isolated;
import org.sami.crw.gui.SessionWorld;
import org.sami.crw.gui.context.LoadedProject;
import org.sami.spn.model.Project;
import org.sami.ui.check.Layout;
import org.sami.ui.command.CommandButton;
import org.sami.ui.look.Look;
import org.sami.ui.look.Theme;
import org.sami.ui.net.NetView;
import org.sami.ui.window.WindowSettings;

/** A mission with a sub-mission, as low as it is in a window of 1280 by 800 at 150 %. */
@Isolated("the look is one for all windows of a process")
@Timeout(120)
class LowMissionNetTest {
    private static final Project PROJECT = SessionWorld.project("""
            {'formatVersion': 1, 'id': 'lake', 'name': 'Lake', 'domain': 'crw',
             'missionTree': [{'label': 'All', 'children': [{'plan': 'outer'}, {'plan': 'inner'}]}],
             'plans': [
              {'id': 'outer', 'name': 'Outer', 'places': [
                {'id': 'go', 'name': 'Go', 'start': true, 'subMissions': [{'id': 'run', 'plan': 'inner'}]}],
               'transitions': [], 'inEdges': [], 'outEdges': []},
              {'id': 'inner', 'name': 'Inner', 'places': [{'id': 'stay', 'name': 'Stay', 'start': true}],
               'transitions': [], 'inEdges': [], 'outEdges': []}
             ]}""");

    @TempDir
    private Path folder;

    @Test
    void theNetHasTheRoomOfTheListOfSubMissionsWhichAreInAMenu() throws Exception {
        scale(150);
        try (SessionWorld world = new SessionWorld(PROJECT, "anna")) {
            MissionMonitor monitor = monitor(world);
            world.start("outer");
            until(
                    "both run",
                    () -> world.context.models().missions().snapshot().running().size() == 2);
            until("its tab is shown", () -> world.whyNot("mission-part").isEmpty());

            onEventThread(() -> {
                Layout.layOut(monitor, 608, 205);
                Layout.layOut(monitor, 608, 205);
                NetView net = find(monitor, "mission-net", NetView.class);
                assertThat(net.getHeight()).isGreaterThanOrEqualTo(90);
                assertThat(isInSight(monitor)).isTrue();

                Layout.layOut(monitor, 608, 600);
                Layout.layOut(monitor, 608, 600);
                assertThat(find(monitor, "mission-shown", JComboBox.class)
                                .getParent()
                                .isVisible())
                        .isTrue();
                assertThat(isInSight(monitor)).isFalse();
                return null;
            });
        } finally {
            scale(100);
        }
    }

    @Test
    void aMissionWithoutSubMissionsHasNoMenuOfThem() throws Exception {
        scale(150);
        try (SessionWorld world = new SessionWorld(PROJECT, "anna")) {
            MissionMonitor monitor = monitor(world);
            world.start("inner");
            until("its tab is shown", () -> world.whyNot("mission-abort").isEmpty());
            onEventThread(() -> {
                Layout.layOut(monitor, 608, 205);
                return null;
            });
            world.start("inner"); // what is shown is told anew
            until(
                    "another runs",
                    () -> world.context.models().missions().snapshot().running().size() == 2);
            assertThat(onEventThread(() -> isInSight(monitor))).isFalse();
        } finally {
            scale(100);
        }
    }

    private MissionMonitor monitor(SessionWorld world) {
        return onEventThread(() -> new MissionMonitor(
                world.context,
                new MissionStarter(
                        world.context, new WindowSettings(folder.resolve("settings")), world.editors(), values -> {}),
                world.editors(),
                new LoadedProject(Optional.empty())));
    }

    /** Whether the button of the menu is. */
    private static boolean isInSight(MissionMonitor monitor) {
        CommandButton part = find(monitor, "mission-part-icon", CommandButton.class);
        return part.isVisible() && part.getParent().isVisible();
    }

    private static void scale(int percent) {
        onEventThread(() -> {
            Look.apply(Theme.LIGHT, percent);
            return null;
        });
    }
}
