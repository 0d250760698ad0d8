package org.sami.crw.cli.vehicle;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sami.crw.cli.CommandResult;
import org.sami.mavlink.testing.SmallCopter;

/** Whoever starts a mission hears at once which copter lacks what the plan asks, not when it hovers over the place. */
@Tag("long")
@Timeout(300)
class MissingCameraTest {
    private static final String MISSING =
            "asks can be done: mav6 cannot take pictures all round: vehicle 6 has no camera (CAM1_TYPE 0)";
    private static final double LAT_DEG = 45.7;
    private static final double LON_DEG = 10.72;

    @TempDir
    private Path folder;

    @Test
    void runSaysItBeforeTheCopterFlies() throws Exception {
        try (SmallCopter copter = new SmallCopter(6, LAT_DEG, LON_DEG, 5)) {
            CommandResult ran = CommandResult.crw(
                    "run",
                    "--domain",
                    "uav",
                    "look",
                    "--connect",
                    copter.address() + "/6",
                    "--area",
                    "30",
                    "--for",
                    "8");

            assertThat(ran.err()).contains(MISSING).doesNotContain("has not said yet");
            assertThat(copter.highestM()).isLessThan(2);
        }
    }

    @Test
    void consoleOfASessionSaysItWhenTheMissionStarts() throws Exception {
        try (SmallCopter copter = new SmallCopter(6, LAT_DEG, LON_DEG, 5)) {
            Path script = Files.writeString(
                    folder.resolve("script"), "wait boats 1 within 60\nstart look\nwait 4\nabort all\nquit\n");

            CommandResult led = CommandResult.crw(
                    "session", "--domain", "uav", "--connect", copter.address() + "/6", "--script", script.toString());

            assertThat(led.out())
                    .as(led.err())
                    .contains("mission 1 of look has begun")
                    .contains(MISSING)
                    .doesNotContain("has not said yet");
        }
    }
}
