package org.sami.crw.mavlink;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.DynamicTest.dynamicTest;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestFactory;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sami.boat.link.BatteryReport;
import org.sami.boat.link.SensorReport;
import org.sami.boat.server.testing.Await;
import org.sami.mavlink.testing.SensorMessages;
import org.sami.mavlink.testing.SmallBoat;

/** The table of what a vehicle measures in docs/mavlink.md, row by row, on a simulated vehicle. */
@Timeout(300)
class MavlinkReportsPageTest {
    private static final Pattern ROW = Pattern.compile("(?m)^\\| [^|]+ \\| `([A-Z_]+)` \\| ([^|]+) \\|$");
    private static final Map<String, Object> MESSAGES = Map.of(
            "WATER_DEPTH", SensorMessages.water(2.5, 18.5),
            "RANGEFINDER", SensorMessages.range(3.5),
            "WIND", SensorMessages.wind(-120, 9.5),
            "DISTANCE_SENSOR", SensorMessages.distance(450),
            "NAMED_VALUE_FLOAT", SensorMessages.named("oxygen", 7.5),
            "NAMED_VALUE_INT", SensorMessages.named("count", 12),
            "CAMERA_FEEDBACK", SensorMessages.picture(3, 45.7001, 10.7201),
            "CAMERA_TRACKING_GEO_STATUS", SensorMessages.target(45.7002, 10.7202));

    /** The first value of each reading that these messages become. */
    private static final Map<String, Double> VALUES = Map.of(
            "autopilot/depth", 2.5,
            "autopilot/temperature", 18.5,
            "autopilot/range", 3.5,
            "autopilot/distance", 4.5,
            "autopilot/wind", 9.5,
            "autopilot/oxygen", 7.5,
            "autopilot/count", 12.0,
            "camera/picture", 3.0,
            "camera/target", (double) SeenTargets.FIRST);

    private static final int PERCENT = 64;

    @TempDir
    private Path folder;

    private static List<MatchResult> rows() throws Exception {
        return ROW.matcher(Files.readString(Path.of("..", "docs", "mavlink.md")))
                .results()
                .toList();
    }

    @Test
    void tableHasARowForTheBatteryAndForEachMessageOfASensor() throws Exception {
        assertThat(rows().stream().map(row -> row.group(1)))
                .containsExactlyInAnyOrderElementsOf(Stream.concat(Stream.of("SYS_STATUS"), MESSAGES.keySet().stream())
                        .toList());
    }

    @TestFactory
    Stream<DynamicTest> eachRowIsSo() throws Exception {
        return rows().stream().map(row -> dynamicTest(row.group(1), () -> walk(row.group(1), row.group(2))));
    }

    private void walk(String message, String becomes) throws Exception {
        try (SmallBoat boat = new SmallBoat(5, 45.7, 10.72, 1);
                LinkClient client = new LinkClient(folder.resolve(message), boat.address() + "/5")) {
            if (message.equals("SYS_STATUS")) {
                boat.reports().charge(PERCENT);
                Await.until(
                        "its charge has come",
                        () -> client.hasHeard(
                                said -> said instanceof BatteryReport report && report.percent() == PERCENT));
                return;
            }
            boat.sends(MESSAGES.get(message));
            List<String> readings = Arrays.stream(becomes.split(", "))
                    .map(reading -> reading.replace("`", ""))
                    .toList();
            assertThat(readings)
                    .allSatisfy(reading -> Await.until(
                            reading,
                            () -> client.hasHeard(
                                    said -> said instanceof SensorReport report && isSame(report, reading))));
        }
    }

    private static boolean isSame(SensorReport report, String reading) {
        return (report.sensor() + "/" + report.channel()).equals(reading)
                && report.values().get(0).equals(VALUES.get(reading));
    }
}
