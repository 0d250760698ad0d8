package org.sami.crw.gui;

import static java.awt.event.KeyEvent.VK_F12;

import java.nio.file.Path;
import java.util.Map;
import javax.swing.JLabel;
import org.sami.boat.link.BoatMode;
import org.sami.crw.gui.window.OperatorWindow;
import org.sami.crw.operator.health.HealthKind;
import org.sami.ui.check.WindowRobot;

/**
 * A window in a process of its own, whose files may only become so large: missions begin until its journal cannot be written any longer. It says what the row
 * of health says then, and whether the fleet stop works, and ends.
 */
public final class FullDiskWindow {
    private static final int MOST_MISSIONS = 3000;

    private FullDiskWindow() {}

    /**
     * Opens it.
     *
     * @param args the data directory
     */
    public static void main(String[] args) throws Exception {
        OpenedWindow opened = OpenedWindow.onBuiltInFleet(Path.of(args[0]));
        OperatorWindow window = opened.window();
        WindowRobot robot = new WindowRobot();
        robot.untilSaid("boats-count", "5 of 5");
        for (int i = 0; i < MOST_MISSIONS && isWell(window); i++) {
            window.session().start("communications-monitoring", "monitoring", Map.of());
            window.session().abortAll();
        }
        robot.untilSaid("health-worst", "Missions stand still");
        JLabel worst = robot.find(JLabel.class, "health-worst");
        System.out.println(WindowRobot.<String>ask(worst::getText));
        robot.press(VK_F12);
        robot.until(
                "all boats are stopped",
                () -> window.session().models().fleet().snapshot().stream()
                        .allMatch(boat ->
                                boat.mode().filter(BoatMode.FLEET_STOP::equals).isPresent()));
        System.out.println("all boats are stopped");
        System.exit(opened.end());
    }

    private static boolean isWell(OperatorWindow window) {
        return WindowRobot.ask(() -> window.session()
                .models()
                .health()
                .snapshot()
                .of(HealthKind.JOURNAL)
                .isEmpty());
    }
}
