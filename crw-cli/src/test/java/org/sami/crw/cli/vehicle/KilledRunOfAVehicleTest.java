package org.sami.crw.cli.vehicle;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sami.boat.server.testing.Await;
import org.sami.crw.cli.Crw;
import org.sami.mavlink.testing.SmallBoat;
import org.sami.spn.testing.JavaProcess;

/** A process that commands a vehicle along a path longer than the vehicle holds is killed, and the next one takes the run up. */
@Tag("process")
@Timeout(900)
class KilledRunOfAVehicleTest {
    private static final double WAIT_S = 600;
    private static final int LOCATIONS = 1_000;
    private static final int TIMES = 60;

    private static final Pattern VISITED = Pattern.compile("visited (\\d+)/" + LOCATIONS);

    private final List<Process> started = new ArrayList<>();

    @TempDir
    private Path folder;

    @Test
    void runGoesOnWhereTheVehicleIsAndNothingIsDrivenTwice() throws Exception {
        Path journal = folder.resolve("journal");
        try (SmallBoat boat = new SmallBoat(5, 45.7, 10.72, TIMES)) {
            Process first = crw(
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

            Process second = crw("second", "resume", journal.toString());
            int alone = boat.mission().visited().size();
            Await.until("it is taken up where it is", WAIT_S, () -> visitedBy("second") >= alone - 1);
            assertThat(boat.mission().uploads()).isEqualTo(1);
            boat.faults().stuck(false);

            assertThat(second.waitFor()).isZero();
            assertThat(boat.mission().visited()).hasSize(LOCATIONS).doesNotHaveDuplicates();
            assertThat(boat.armings()).isEqualTo(1);
        } finally {
            started.forEach(Process::destroyForcibly);
        }
    }

    /** How many locations are visited, as a process says every few seconds. */
    private int visitedBy(String name) {
        try {
            return VISITED.matcher(Files.readString(folder.resolve(name + ".err")))
                    .results()
                    .mapToInt(found -> Integer.parseInt(found.group(1)))
                    .max()
                    .orElse(0);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private Process crw(String name, String... arguments) throws Exception {
        ProcessBuilder builder = JavaProcess.builder(folder, Crw.class, arguments);
        List<String> line = new ArrayList<>(builder.command());
        line.add(1, "-Dsami.vehicles=" + folder.resolve("vehicles"));
        Process process = builder.command(line)
                .redirectOutput(folder.resolve(name + ".out").toFile())
                .redirectError(folder.resolve(name + ".err").toFile())
                .start();
        started.add(process);
        return process;
    }
}
