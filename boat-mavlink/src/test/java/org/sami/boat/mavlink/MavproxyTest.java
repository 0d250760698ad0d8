package org.sami.boat.mavlink;

import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.BufferedWriter;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sami.boat.server.testing.Await;

/** A boat of ours and MAVProxy, whose commands are typed as its user types them. */
@Tag("long")
@Timeout(900)
class MavproxyTest {
    private static final double WAIT_S = 120;
    private static final String MISSION = """
        QGC WPL 110
        0	1	0	16	0	0	0	0	45.4000	10.9000	0	1
        1	0	3	16	0	0	0	0	45.4001	10.9000	0	1
        2	0	3	16	0	0	0	0	45.4002	10.9000	0	1
        """;

    private static final String FENCE = """
        QGC WPL 110
        0	0	0	5001	4	0	0	0	45.3995	10.8995	0	1
        1	0	0	5001	4	0	0	0	45.4005	10.8995	0	1
        2	0	0	5001	4	0	0	0	45.4005	10.9005	0	1
        3	0	0	5001	4	0	0	0	45.3995	10.9005	0	1
        4	0	0	5004	20	0	0	0	45.3997	10.9000	0	1
        """;

    /** MAVProxy that runs: what it prints is looked for in its order. */
    private static final class Typed implements AutoCloseable {
        private final Process process;
        private final BufferedWriter keys;
        private final StringBuilder printed = new StringBuilder(); // guarded by itself
        private int seen;

        Typed(int port, Path folder) throws IOException {
            process = new ProcessBuilder(
                            StationPrograms.python(),
                            "-W",
                            "ignore",
                            "-m",
                            "MAVProxy.mavproxy",
                            "--master=udpin:127.0.0.1:" + port)
                    .directory(folder.toFile())
                    .redirectErrorStream(true)
                    .start();
            keys = process.outputWriter(StandardCharsets.UTF_8);
            Thread reader = new Thread(this::read, "mavproxy");
            reader.setDaemon(true);
            reader.start();
        }

        private void read() {
            try (InputStream out = process.getInputStream()) {
                for (int next = out.read(); next >= 0; next = out.read()) {
                    synchronized (printed) {
                        printed.append((char) next);
                    }
                }
            } catch (IOException ended) {
                // what it printed before counts
            }
        }

        void type(String line) throws IOException {
            keys.write(line + "\n");
            keys.flush();
        }

        /** Waits until it prints a text after those that were waited for before. */
        void until(String words) {
            try {
                Await.until("it prints " + words, WAIT_S, () -> isSeen(words));
            } catch (AssertionError never) {
                synchronized (printed) {
                    throw new AssertionError(never.getMessage() + " after:\n" + printed, never);
                }
            }
        }

        private boolean isSeen(String words) {
            synchronized (printed) {
                int at = printed.indexOf(words, seen);
                seen = at < 0 ? seen : at + words.length();
                return at >= 0;
            }
        }

        @Override
        public void close() {
            process.descendants().forEach(ProcessHandle::destroyForcibly);
            process.destroyForcibly();
        }
    }

    @Test
    void mavproxySeesTheBoatReadsItsParametersAndSendsItOnAMission(@TempDir Path folder) throws Exception {
        assumeTrue(StationPrograms.has("MAVProxy"), () -> StationPrograms.missing("MAVProxy"));
        Files.writeString(folder.resolve("mission.txt"), MISSION);
        Files.writeString(folder.resolve("fence.txt"), FENCE);
        try (BoatWithStation boat = BoatWithStation.patient();
                Typed station = new Typed(boat.port, folder)) {
            station.until("Detected vehicle 7:1");
            station.until("parameters to");
            station.type("param show CRUISE_SPEED");
            station.until("CRUISE_SPEED     1.5");
            station.type("fence load fence.txt");
            station.until("Got MISSION_ACK: TYPE_FENCE: ACCEPTED");
            station.until("fence present");
            station.type("fence list");
            station.until("Saved 5 fence");
            station.type("wp load mission.txt");
            station.until("Got MISSION_ACK: TYPE_MISSION: ACCEPTED");
            station.type("mode AUTO");
            station.until("Mode AUTO");
            station.type("arm throttle");
            station.until("ARMED");
            station.until("waypoint 2");
            station.until("Mode LOITER");
            station.type("wp list");
            station.until("Saved 3 waypoints");
            station.type("disarm");
            station.until("DISARMED");
            station.type("fence clear");
            station.until("fence removed");
        }
    }
}
