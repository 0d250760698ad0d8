package org.sami.crw.cli.vehicle;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sami.boat.server.testing.Await;
import org.sami.mavlink.testing.SmallBoat;

/** A process that commands a vehicle along a path longer than the vehicle holds is killed, and the next one takes the run up. */
@Tag("process")
@Timeout(900)
class KilledRunOfAVehicleTest {
    private static final double WAIT_S = 600;
    private static final int LOCATIONS = 1_000;
    private static final int TIMES = 60;

    @TempDir
    private Path folder;

    @Test
    void runGoesOnWhereTheVehicleIsAndNothingIsDrivenTwice() throws Exception {
        Path journal = folder.resolve("journal");
        try (RunProcesses runs = new RunProcesses(folder, LOCATIONS);
                SmallBoat boat = new SmallBoat(5, 45.7, 10.72, TIMES)) {
            Process first = runs.crw(
                    "first",
                    "run",
                    "clv",
                    "--connect",
                    boat.address() + "/5",
                    "--area",
                    "100",
                    "--locations",
                    Integer.toString(LOCATIONS),
                    "--answer-after",
                    "0.2",
                    "--journal",
                    journal.toString());
            Await.until(
                    "it is under way", WAIT_S, () -> boat.mission().visited().size() > 200);
            first.destroyForcibly().waitFor();
            int killed = boat.mission().visited().size();
            Await.until(
                    "it drives on by itself",
                    WAIT_S,
                    () -> boat.mission().visited().size() > killed + 20);
            boat.faults()
                    .stuck(true); // the next process may start slowly, and the vehicle is not to come to the end of
            // its part

            Process second = runs.crw("second", "resume", journal.toString());
            int alone = boat.mission().visited().size();
            Await.until("it is taken up where it is", WAIT_S, () -> runs.visitedBy("second") >= alone - 1);
            assertThat(boat.mission().uploads()).isEqualTo(1);
            boat.faults().stuck(false);

            assertThat(second.waitFor()).isZero();
            assertThat(boat.mission().visited()).hasSize(LOCATIONS).doesNotHaveDuplicates();
            assertThat(boat.armings()).isEqualTo(1);
        }
    }
}
