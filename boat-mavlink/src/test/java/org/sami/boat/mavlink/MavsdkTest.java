package org.sami.boat.mavlink;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.net.InetAddress;
import java.net.ServerSocket;
import java.nio.file.Path;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** A boat of ours and a program on MAVSDK. */
@Tag("long")
@Timeout(900)
class MavsdkTest {
    @Test
    void aProgramOnMavsdkSeesTheBoatAndSendsItOnAMission(@TempDir Path folder) throws Exception {
        assumeTrue(StationPrograms.has("mavsdk"), () -> StationPrograms.missing("mavsdk"));
        int own;
        try (ServerSocket free = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
            own = free.getLocalPort(); // between MAVSDK's server and the script
        }
        try (BoatWithStation boat = BoatWithStation.patient()) {
            assertThat(StationPrograms.runScript("mavsdk-station.py", folder, "" + boat.port, "" + own)
                            .lines()
                            .filter(line -> !line.contains(".cpp:"))) // MAVSDK's own log
                    .containsExactly("sees HOLD", "reads 1.5", "holds 2", "armed True", "reaches 2", "stopped False");
        }
    }
}
