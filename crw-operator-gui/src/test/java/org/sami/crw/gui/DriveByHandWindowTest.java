package org.sami.crw.gui;

import static java.awt.event.KeyEvent.VK_CONTROL;
import static java.awt.event.KeyEvent.VK_D;
import static java.awt.event.KeyEvent.VK_SHIFT;
import static java.awt.event.KeyEvent.VK_UP;

import java.awt.Frame;
import java.awt.Robot;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sami.crw.operator.boat.BoatSnapshot;
import org.sami.ui.check.RealDisplay;
import org.sami.ui.check.WindowRobot;

/** A boat is driven by a key that is held, in the real window. */
@Tag("window")
class DriveByHandWindowTest {
    private static final double GOES_MPS = 0.3;
    private static final double STANDS_MPS = 0.1;

    @TempDir
    private Path folder;

    @Test
    void aBoatStandsOnceTheWindowIsMinimisedWhileTheKeyIsStillHeld() throws Exception {
        RealDisplay.assumed();
        WindowRobot robot = new WindowRobot();
        Robot hand = new Robot();
        try (LoopbackFleet fleet = new LoopbackFleet(List.of("anna"));
                OpenedWindow opened = OpenedWindow.over(fleet.addresses(), folder)) {
            robot.untilSaid("boats-count", "1 of 1");
            robot.clickRow("boats-table", "anna");
            robot.press(VK_D, VK_CONTROL, VK_SHIFT);
            robot.untilSaid("notice", "You drive anna");
            hand.keyPress(VK_UP);
            try {
                robot.until("it goes", () -> speed(opened) > GOES_MPS);

                WindowRobot.ask(() -> {
                    opened.window().frame().setExtendedState(Frame.ICONIFIED);
                    return null;
                });

                robot.until("it stands", 60, () -> speed(opened) < STANDS_MPS);
            } finally {
                hand.keyRelease(VK_UP);
            }
        }
    }

    private static double speed(OpenedWindow opened) {
        return opened.window()
                .session()
                .models()
                .fleet()
                .boat("anna")
                .flatMap(BoatSnapshot::pose)
                .map(pose -> Math.abs(pose.speedMps()))
                .orElse(0.0);
    }
}
