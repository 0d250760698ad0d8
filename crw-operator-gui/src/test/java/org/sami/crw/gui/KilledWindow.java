package org.sami.crw.gui;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.sami.crw.gui.start.DataDirectory;
import org.sami.crw.gui.start.StartOptions;
import org.sami.palette.Theme;
import org.sami.ui.check.WindowRobot;

/** A window in a process of its own, in which a mission is started by the pointer; it says when the mission runs, and waits to be killed. */
final class KilledWindow {
    private KilledWindow() {}

    /**
     * Opens it.
     *
     * @param args the data directory
     */
    public static void main(String[] args) throws Exception {
        WindowStart.open(options(false), DataDirectory.open(Path.of(args[0])), code -> {});
        WindowRobot robot = new WindowRobot();
        robot.untilSaid("boats-count", "5 of 5");
        robot.click("mission-start");
        robot.untilSaid("missions-count", "1 mission");
        robot.untilSaid("decisions-count", "1 decision");
        System.out.println("runs");
    }

    static StartOptions options(boolean resume) {
        return new StartOptions(
                List.of(), Optional.empty(), Optional.of(Theme.LIGHT), Optional.of(100), Optional.of(resume));
    }
}
