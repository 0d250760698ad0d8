package org.sami.boat.mavlink;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** A boat of ours and a ground station that this project has not written, on pymavlink. */
@Timeout(900)
class PymavlinkTest {
    @Test
    void aStationOnPymavlinkSeesTheBoatAndSendsItOnAMission(@TempDir Path folder) throws Exception {
        assumeTrue(StationPrograms.has("pymavlink"), () -> StationPrograms.missing("pymavlink"));
        try (BoatWithStation boat = BoatWithStation.patient()) {
            assertThat(StationPrograms.runScript("station.py", folder, "" + boat.port)
                            .lines())
                    .containsExactly(
                            "sees HOLD",
                            "reads 1.5",
                            "fence 0 True",
                            "half a fence 5 True",
                            "sent 0",
                            "arms 0",
                            "reaches 2",
                            "stopped");
        }
    }
}
