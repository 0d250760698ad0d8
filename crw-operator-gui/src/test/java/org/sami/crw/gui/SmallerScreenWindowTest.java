package org.sami.crw.gui;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Component;
import java.awt.GraphicsEnvironment;
import java.awt.Rectangle;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sami.ui.check.RealDisplay;
import org.sami.ui.check.WindowRobot;

/** A window that was left on a large screen is begun again on a smaller one. */
@Tag("window")
class SmallerScreenWindowTest {
    private final WindowRobot robot = new WindowRobot();

    @TempDir
    private Path folder;

    @Test
    void fleetStopIsInSightWhereTheWindowWasLeftOnALargerScreen() throws Exception {
        RealDisplay.assumed();
        Path arrangement = folder.resolve("arrangement.xml");
        try (LoopbackFleet fleet = new LoopbackFleet(List.of("anna"))) {
            withWindow(fleet, () -> robot.until("the arrangement is kept", () -> Files.exists(arrangement)));
            String kept = Files.readString(arrangement);
            String larger =
                    kept.replaceFirst("location=\"[^\"]*\" size=\"[^\"]*\"", "location=\"900,700\" size=\"3800,2100\"");
            assertThat(larger).isNotEqualTo(kept);
            Files.writeString(arrangement, larger);

            withWindow(fleet, () -> {
                Component button = robot.find(Component.class, "fleet-stop");
                robot.until(
                        "the fleet stop is on the screen",
                        () -> GraphicsEnvironment.getLocalGraphicsEnvironment()
                                .getMaximumWindowBounds()
                                .contains(new Rectangle(button.getLocationOnScreen(), button.getSize())));
            });
        }
    }

    private void withWindow(LoopbackFleet fleet, Runnable look) throws Exception {
        try (OpenedWindow opened = OpenedWindow.over(fleet.addresses(), folder)) {
            robot.untilSaid("boats-count", "1 of 1");
            look.run();
        }
    }
}
