package org.sami.boat.mavlink;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Objects;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sami.boat.link.LostLinkAction;

/** A boat of ours and a ground station that this project has not written, where Python has pymavlink; the variable PYTHON names another Python than the usual one. */
@Timeout(900)
class PymavlinkTest {
    private static final String PYTHON = Objects.requireNonNullElse(System.getenv("PYTHON"), "python3");

    private static String run(String... command) throws Exception {
        Process process = new ProcessBuilder(command).redirectErrorStream(true).start();
        try (InputStream out = process.getInputStream()) {
            String text = new String(out.readAllBytes(), StandardCharsets.UTF_8);
            return process.waitFor() == 0 ? text : "failed: " + text;
        } finally {
            process.destroyForcibly();
        }
    }

    private static boolean hasPymavlink() throws Exception {
        try {
            return run(PYTHON, "-c", "import pymavlink").isEmpty();
        } catch (IOException noPython) {
            return false;
        }
    }

    @Test
    void aStationOnPymavlinkSeesTheBoatAndSendsItOnAMission(@TempDir Path folder) throws Exception {
        assumeTrue(hasPymavlink(), "skipped: " + PYTHON + " has no pymavlink (pip install pymavlink)");
        Path script = folder.resolve("station.py");
        try (InputStream text = PymavlinkTest.class.getResourceAsStream("station.py")) {
            Files.write(script, text.readAllBytes());
        }
        try (BoatWithStation boat = new BoatWithStation(LostLinkAction.HOLD)) {
            List<String> lines = run(PYTHON, script.toString(), String.valueOf(boat.port))
                    .lines()
                    .toList();

            assertThat(lines).containsExactly("sees HOLD", "reads 1.5", "sent 0", "arms 0", "reaches 2", "stopped");
        }
    }
}
