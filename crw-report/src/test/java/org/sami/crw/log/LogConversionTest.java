package org.sami.crw.log;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.tuple;
import static org.assertj.core.api.Assertions.within;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.BufferedWriter;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.stream.Stream;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class LogConversionTest {
    @TempDir
    Path folder;

    @Test
    void trackIsMeasuredAndSplitWhereNoBoatCanHaveGone() throws Exception {
        Path log = log(
                pose(100, 480_000, 4_600_000),
                pose(300, 480_000, 4_600_000),
                pose(500, 500_000, 4_482_700),
                pose(1500, 500_003, 4_482_704),
                pose(2500, 500_006, 4_482_708));

        LogSummary summary = LogConversion.summary(log);

        assertThat(summary.durationMillis()).isEqualTo(2400);
        assertThat(summary.poses().stretches())
                .extracting(
                        TrackSegment::number,
                        TrackSegment::firstLine,
                        TrackSegment::positions,
                        TrackSegment::startMillis)
                .containsExactly(tuple(1, 1L, 2L, 0L), tuple(2, 3L, 3L, 400L));
        assertThat(summary.poses().distanceM()).isCloseTo(10 / 0.9996, within(0.01));
    }

    @Test
    void nothingThatWasNotUnderstoodIsLost() throws Exception {
        Path log = log(
                "100 01:02:03,4 COMPASS: 0.5",
                "what is this",
                "300 01:02:03,6 SONAR: 5",
                "250 01:02:03,6 COMPASS: 0.25",
                "",
                "400 01:02:03,7 POSE: {here}",
                "500 01:02:03,8 COMPASS: 0.75");

        LogSummary summary = LogConversion.report(log, folder);

        assertThat(summary.lines()).isEqualTo(7);
        assertThat(summary.entries()).isEqualTo(3);
        assertThat(summary.unreadLines()).isEqualTo(3);
        assertThat(summary.problems())
                .extracting(FaultCount::fault, FaultCount::lines)
                .containsExactly(
                        tuple(LineFault.NO_ENTRY, List.of(2L)),
                        tuple(LineFault.UNKNOWN_TOPIC, List.of(3L)),
                        tuple(LineFault.BAD_CONTENT, List.of(6L)));
        assertThat(Files.readString(folder.resolve("problems.csv")))
                .contains("2,no-entry,")
                .contains("what is this")
                .contains("300 01:02:03,6 SONAR: 5")
                .contains("POSE: {here}");
    }

    @Test
    void lineOutOfOrderIsUsedAndNamed() throws Exception {
        LogSummary summary = LogConversion.summary(
                log("300 01:02:03,6 COMPASS: 0.25", "250 01:02:03,6 COMPASS: 0.5", "400 01:02:03,7 COMPASS: 0.5"));

        assertThat(summary.entries()).isEqualTo(3);
        assertThat(summary.unreadLines()).isZero();
        assertThat(summary.problems())
                .extracting(FaultCount::fault, FaultCount::lines)
                .containsExactly(tuple(LineFault.TIME_WENT_BACK, List.of(2L)));
    }

    @Test
    void lastLineThatWasCutOffIsCalledThat() throws Exception {
        Path log = file("100 01:02:03,4 COMPASS: 0.5\n200 01:02:03,5 POSE: {50000".getBytes(StandardCharsets.UTF_8));

        LogSummary summary = LogConversion.summary(log);

        assertThat(summary.entries()).isEqualTo(1);
        assertThat(summary.problems())
                .extracting(FaultCount::fault, FaultCount::lines)
                .containsExactly(tuple(LineFault.CUT_OFF, List.of(2L)));
    }

    @Test
    void endlessLineIsNotHeldInMemory() throws Exception {
        Path log = log("100 01:02:03,4 COMPASS: 0.5", "9".repeat(3_000_000), "300 01:02:03,6 COMPASS: 0.75");

        LogSummary summary = LogConversion.report(log, folder);

        assertThat(summary.entries()).isEqualTo(2);
        assertThat(summary.problems())
                .extracting(FaultCount::fault, FaultCount::lines)
                .containsExactly(tuple(LineFault.TOO_LONG, List.of(2L)));
        assertThat(folder.resolve("problems.csv")).isNotEmptyFile();
        assertThat(Files.size(folder.resolve("problems.csv"))).isLessThan(2000);
    }

    @Test
    void longTrackIsThinnedForDrawingAndCompleteInTheTable() throws Exception {
        int poses = 60_000;
        Path log = folder.resolve("long.txt");
        try (BufferedWriter lines = Files.newBufferedWriter(log)) {
            for (int i = 0; i < poses; i++) {
                lines.write(pose(i * 1000L, 400_000 + i, 4_482_700) + "\n");
            }
        }
        Path out = folder.resolve("out");

        LogSummary summary = LogConversion.report(log, out);

        TrackSegment stretch = summary.poses().stretches().get(0);
        assertThat(stretch.positions()).isEqualTo(poses);
        assertThat(stretch.points()).hasSizeBetween(5_000, ThinnedWay.MOST_POINTS + 1);
        assertThat(stretch.last().lonDeg())
                .as("the last point stays, however thinned")
                .isEqualTo(new UtmGrid()
                        .point("17North", 400_000 + poses - 1, 4_482_700)
                        .lonDeg());
        assertThat(Files.readAllLines(out.resolve("tracks.csv"))).hasSize(poses + 1);
    }

    @Test
    void reportHasEveryFileWithWhatBelongsThere() throws Exception {
        Path log = log(
                pose(100, 500_000, 4_482_700),
                "150 01:02:03,4 ES2: [e, 9.5, 30.0]",
                "160 01:02:03,4 SETGAINS: 0 [3.0, 0.0, 0.0]",
                "170 01:02:03,4 GPS: [500001.0 m, 4482700.0 m], 17T, 190.0, 0.0",
                pose(1100, 500_005, 4_482_700));
        Path out = folder.resolve("out");

        LogConversion.report(log, out);

        try (Stream<Path> files = Files.list(out)) {
            assertThat(files.map(f -> f.getFileName().toString()))
                    .containsExactlyInAnyOrder(
                            "summary.json",
                            "tracks.csv",
                            "track.geojson",
                            "readings.csv",
                            "commands.csv",
                            "problems.csv",
                            "map.png");
        }
        assertThat(Files.readAllLines(out.resolve("readings.csv")))
                .containsExactly(
                        "line,at_s,sensor,channel,value,lat_deg,lon_deg",
                        "2,0.050,ES2,1,9.5,40.4950024,-81.0000000",
                        "2,0.050,ES2,2,30.0,40.4950024,-81.0000000");
        assertThat(Files.readAllLines(out.resolve("commands.csv")))
                .containsExactly(
                        "line,at_s,clock,topic,command", "3,0.060,\"01:02:03,4\",SETGAINS,\"0 [3.0, 0.0, 0.0]\"");
        JsonNode geo = new ObjectMapper().readTree(out.resolve("track.geojson").toFile());
        assertThat(geo.at("/features/0/geometry/type").asText()).isEqualTo("LineString");
        assertThat(geo.at("/features/0/geometry/coordinates/0/0").asDouble()).isEqualTo(-81.0);
        assertThat(geo.at("/features/1/geometry/type").asText()).isEqualTo("Point");
        JsonNode json = new ObjectMapper().readTree(out.resolve("summary.json").toFile());
        assertThat(json.at("/poses/positions").asInt()).isEqualTo(2);
        assertThat(json.at("/fixes/positions").asInt()).isEqualTo(1);
        assertThat(ImageIO.read(out.resolve("map.png").toFile()).getWidth()).isPositive();
    }

    @Test
    void logWithoutPositionsHasNoPicture() throws Exception {
        Path out = folder.resolve("out");
        Files.createDirectories(out);
        Files.writeString(out.resolve("map.png"), "of another log");

        LogConversion.report(log("100 01:02:03,4 COMPASS: 0.5"), out);

        assertThat(out.resolve("map.png")).doesNotExist();
        assertThat(out.resolve("summary.json")).exists();
    }

    @Test
    void farPositionBeforeTheFirstFixIsNamedAndNotDrawn() throws Exception {
        LogSummary summary = LogConversion.summary(
                log(pose(100, 480_000, 4_600_000), pose(300, 500_000, 4_482_700), pose(1300, 500_005, 4_482_700)));

        assertThat(LogPicture.leftOut(summary)).extracting(TrackSegment::number).containsExactly(1);
        assertThat(LogSummaryText.text(summary)).contains("not in the picture");
    }

    @ParameterizedTest
    @CsvSource({
        "'', is empty",
        "'a\u0002b\n', is not a text file: byte 2 is 0x02",
        "'this is\na letter\n', none of its 2 lines is an entry",
    })
    void whatIsNoLogIsRefusedAndNothingIsWritten(String content, String message) throws Exception {
        Path file = file(content.getBytes(StandardCharsets.UTF_8));
        Path out = folder.resolve("out");

        assertThatThrownBy(() -> LogConversion.report(file, out))
                .isInstanceOf(NotALogException.class)
                .hasMessageContaining(message);

        try (Stream<Path> files = Files.list(out)) {
            assertThat(files).isEmpty();
        }
    }

    @ParameterizedTest
    @CsvSource({
        "platypus-airboat_20130807_063622.txt, 463, 118, 19, 48",
        "platypus-airboat_20151220_043848.txt, 100, 15, 0, 0",
    })
    void realLogsAreReadToTheLastLine(String name, long lines, long poses, long fixes, long metres) throws Exception {
        Path file = shared("field-data").resolve(name);
        Assumptions.assumeTrue(Files.exists(file), "skipped: there is no " + file);

        LogSummary summary = LogConversion.report(file, folder.resolve("out"));

        assertThat(summary.lines()).isEqualTo(lines);
        assertThat(summary.unreadLines()).isZero();
        assertThat(summary.poses().positions()).isEqualTo(poses);
        assertThat(summary.fixes().positions()).isEqualTo(fixes);
        assertThat(Math.round(summary.poses().distanceM())).isEqualTo(metres);
        assertThat(ImageIO.read(folder.resolve("out/map.png").toFile()).getWidth())
                .isPositive();
    }

    /** A folder of files next to the project, which are no part of it; tests run in their module's folder. */
    private static Path shared(String name) {
        return Path.of("..", "..", "shared", name);
    }

    private Path log(String... lines) throws IOException {
        return file((String.join("\n", lines) + "\n").getBytes(StandardCharsets.UTF_8));
    }

    private Path file(byte[] content) throws IOException {
        return Files.write(folder.resolve("boat.txt"), content);
    }

    private static String pose(long millis, double eastingM, double northingM) {
        return String.format(
                Locale.ROOT,
                "%d 01:02:03,4 POSE: {%.3f, %.3f, 172.35, Q[0.0,0.0,0.5]} @ 17North",
                millis,
                eastingM,
                northingM);
    }
}
