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
import org.sami.crw.gui.TextScale;
import org.sami.crw.gui.context.LoadedProject;
import org.sami.spn.model.Project;
import org.sami.ui.check.Layout;
import org.sami.ui.command.CommandButton;
import org.sami.ui.net.NetView;
import org.sami.ui.window.WindowSettings;

/** A mission with a sub-mission, as low as it is in a window of 1280 by 800 at 150 %. */
@Isolated("the look is one for all windows of a process")
@Timeout(900)
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
        try (TextScale large = TextScale.percent(150);
                SessionWorld world = new SessionWorld(PROJECT, "anna")) {
            MissionMonitor monitor = monitor(world);
            world.start("outer");
            until(
                    "both run",
                    () -> world.context.models().missions().snapshot().running().size() == 2);
            until("its tab is shown", () -> world.whyNot("mission-sub-mission").isEmpty());

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
        }
    }

    @Test
    void aMissionWithoutSubMissionsHasNoMenuOfThem() throws Exception {
        try (TextScale large = TextScale.percent(150);
                SessionWorld world = new SessionWorld(PROJECT, "anna")) {
            MissionMonitor monitor = monitor(world);
            world.start("inner");
            until("its tab is shown", () -> world.whyNot("mission-abort").isEmpty());
            onEventThread(() -> {
                Layout.layOut(monitor, 608, 205);
                return null;
            });
            world.start("inner"); // what is shown is told again
            until(
                    "another runs",
                    () -> world.context.models().missions().snapshot().running().size() == 2);
            assertThat(onEventThread(() -> isInSight(monitor))).isFalse();
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
        CommandButton icon = find(monitor, "mission-sub-mission-icon", CommandButton.class);
        return icon.isVisible() && icon.getParent().isVisible();
    }
}
