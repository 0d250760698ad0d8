package org.sami.crw.gui.robot;

import static java.awt.event.KeyEvent.VK_B;
import static java.awt.event.KeyEvent.VK_CONTROL;
import static java.awt.event.KeyEvent.VK_DELETE;
import static java.awt.event.KeyEvent.VK_ENTER;
import static java.awt.event.KeyEvent.VK_F1;
import static java.awt.event.KeyEvent.VK_F12;
import static java.awt.event.KeyEvent.VK_G;
import static java.awt.event.KeyEvent.VK_SHIFT;
import static org.assertj.core.api.Assertions.assertThat;
import static org.sami.crw.gui.EventThreadCall.onEventThread;

import java.awt.Component;
import java.util.List;
import javax.swing.AbstractButton;
import javax.swing.SwingUtilities;
import org.sami.spn.value.GeoPoint;
import org.sami.ui.geo.MapFrame;
import org.sami.ui.map.MapView;

/** What operators do wrong with boats and with the fleet stop. */
final class FleetMistakes {
    /** The rows. */
    static final List<RobotRow> ROWS = List.of(
            new RobotRow(
                    "F12 while a sheet is open",
                    "all boats are stopped; the sheet is as it was",
                    FleetMistakes::stopOverSheet),
            new RobotRow(
                    "F12 in the middle of typing",
                    "all boats are stopped; the text is as it was",
                    FleetMistakes::stopTyping),
            new RobotRow(
                    "A double click on Release fleet",
                    "the fleet stays stopped: the second step is another press",
                    FleetMistakes::releaseTwice),
            new RobotRow(
                    "The second step of the release without the first",
                    "the strip says what comes first; the fleet stays stopped",
                    FleetMistakes::secondStep),
            new RobotRow(
                    "Go here into a no-go area", "refused with the reason; the boat stays", FleetMistakes::goIntoNoGo),
            new RobotRow(
                    "Go here while the fleet is stopped",
                    "the strip says that nothing moves before the release; the boat does not move",
                    FleetMistakes::goWhileStopped),
            new RobotRow(
                    "Cancel the command of a boat that has none",
                    "the strip says so; nothing else happens",
                    FleetMistakes::cancelNothing),
            new RobotRow(
                    "Connect to a port that cannot be",
                    "the form says which ports there are; nothing is tried",
                    FleetMistakes::wrongPort));

    private static final GeoPoint NO_GO = GeoPoint.of(25.3577, 51.5267);
    private static final GeoPoint FREE = GeoPoint.of(25.3598, 51.5278);

    private FleetMistakes() {}

    private static void stop(RobotWorld world) {
        world.robot.press(VK_F12);
        world.until("all boats are stopped", world::allStopped);
    }

    private static void stopOverSheet(RobotWorld world) {
        world.robot.press(VK_F1);
        world.robot.untilShown("command-keys-window");
        stop(world);
        assertThat(world.isShown("command-keys-window")).isTrue();
    }

    private static void stopTyping(RobotWorld world) {
        world.robot.press(VK_B, VK_CONTROL);
        world.robot.untilFocused("boat-connect-address");
        world.robot.type("10.0.0.7");
        stop(world);
        assertThat(world.text("boat-connect-address")).isEqualTo("10.0.0.7");
    }

    private static void releaseTwice(RobotWorld world) throws Exception {
        stop(world);
        AbstractButton release = world.robot.find(AbstractButton.class, "fleet-release");
        int x = onEventThread(release::getWidth) / 2;
        world.robot.doubleClickAt(release, x, 12);
        world.robot.untilShown("fleet-release-confirm");
        RobotWorld.get(world.session().fleet().boats());
        assertThat(world.allStopped()).isTrue();
    }

    private static void secondStep(RobotWorld world) {
        stop(world);
        world.robot.press(VK_ENTER, VK_CONTROL, VK_SHIFT);
        world.says("notice", "press 'Release fleet' first");
        assertThat(world.allStopped()).isTrue();
    }

    private static void go(RobotWorld world, String boat, GeoPoint to) {
        world.robot.clickRow("boats-table", boat);
        world.robot.press(VK_G, VK_CONTROL);
        Component map = world.robot.find(Component.class, "map-canvas");
        MapView view = onEventThread(() -> (MapView) SwingUtilities.getAncestorOfClass(MapView.class, map));
        MapFrame frame = onEventThread(() -> {
            view.centre(to);
            return view.frame();
        });
        world.robot.clickAt(map, (int) frame.px(to), (int) frame.py(to));
    }

    private static void goIntoNoGo(RobotWorld world) {
        go(world, "emil", NO_GO);
        world.says("notice", "inside what is to be avoided");
        assertThat(world.boat("emil").points()).isZero();
    }

    private static void goWhileStopped(RobotWorld world) {
        stop(world);
        go(world, "emil", FREE);
        world.says("notice", "nothing moves before the release");
        assertThat(world.allStopped()).isTrue();
    }

    private static void cancelNothing(RobotWorld world) {
        world.robot.clickRow("boats-table", "dora");
        world.robot.press(VK_DELETE, VK_CONTROL);
        world.says("notice", "Cancel the command");
        assertThat(world.boat("dora").command()).isEmpty();
    }

    private static void wrongPort(RobotWorld world) {
        world.robot.press(VK_B, VK_CONTROL);
        world.robot.untilFocused("boat-connect-address");
        world.robot.type("127.0.0.1:99999\n");
        world.says("boat-connect-said", "65535");
        assertThat(world.isOn("boat-connect-do")).isFalse();
        assertThat(world.session().models().unreached().snapshot()).isEmpty();
    }
}
