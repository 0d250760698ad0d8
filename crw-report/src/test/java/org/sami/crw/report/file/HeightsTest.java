package org.sami.crw.report.file;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Instant;
import java.time.ZoneId;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sami.crw.report.BoatResult;
import org.sami.crw.report.RunOrigin;
import org.sami.crw.report.RunReport;
import org.sami.crw.report.SampleReport;
import org.sami.crw.report.TrackPoint;

/** The files of a run of a boat and a copter say how high the copter was, and of the boat what they always said. */
class HeightsTest {
    private static final RunReport REPORT = report();

    @TempDir
    Path folder;

    private static RunReport report() {
        RunReport sample = SampleReport.of(1, 1);
        BoatResult boat = sample.boats().get(0);
        List<TrackPoint> flight = List.of(at(0, 0), at(10_000, 30.25), at(20_000, 12));
        BoatResult copter = new BoatResult("copter1", boat.link(), 0, 80, 0, 1, flight);
        return new RunReport(
                        sample.header(),
                        sample.result(),
                        List.of(boat, copter),
                        sample.locations(),
                        sample.decisions(),
                        sample.firings(),
                        sample.interrupts(),
                        sample.notes())
                .withOrigin(new RunOrigin(Instant.parse("2026-11-22T08:00:00Z"), ZoneId.of("UTC"), "1"));
    }

    private static TrackPoint at(long millis, double altM) {
        return new TrackPoint(millis, 0, 0, 45, 10, 0, 80, altM);
    }

    private String file(String name, RunReport report) throws Exception {
        new ReportFolder(folder).write(report);
        return Files.readString(folder.resolve(name));
    }

    @Test
    void tracksEndWithTheHeightWhereOneFlew() throws Exception {
        List<String> lines = file("tracks.csv", REPORT).lines().toList();

        assertThat(lines.get(0)).endsWith(",battery_percent,alt_m");
        assertThat(lines).contains("copter1,10.000,45.0000000,10.0000000,0.000,0.000,0.00,80.00,30.25");
        assertThat(lines.get(1)).startsWith("boat1,").endsWith(",0.00");
        assertThat(file("tracks.csv", SampleReport.of(1, 1)).lines().findFirst().orElseThrow())
                .endsWith(",battery_percent");
    }

    @Test
    void gpxHasTheElevationBeforeTheTime() throws Exception {
        assertThat(file("run.gpx", REPORT).replaceAll(">\\s+<", "><"))
                .contains("<ele>30.25</ele><time>2026-11-22T08:00:10Z</time>")
                .containsOnlyOnce("<ele>30.25</ele>");
        assertThat(file("run.gpx", SampleReport.of(1, 1))).doesNotContain("<ele>");
    }

    @Test
    void kmlHasHeightsOverTheGroundOfWhatFlewOnly() throws Exception {
        assertThat(file("run.kml", REPORT).replaceAll(">\\s+<", "><"))
                .containsOnlyOnce("<gx:Track><altitudeMode>relativeToGround</altitudeMode><when>")
                .contains("<gx:coord>10.0000000 45.0000000 30.25</gx:coord>");
        assertThat(file("run.kml", SampleReport.of(1, 1))).doesNotContain("altitudeMode");
    }

    @Test
    void geoJsonHasAHeightForEachPositionOfWhatFlew() throws Exception {
        List<JsonNode> heights = new ArrayList<>();
        new ObjectMapper().readTree(file("run.geojson", REPORT)).get("features").forEach(feature -> {
            if (feature.at("/properties/kind").asText().equals("track")) {
                heights.add(feature.at("/properties/altM"));
            }
        });

        assertThat(heights.get(0).isMissingNode()).isTrue();
        assertThat(heights.get(1)).hasToString("[0.0,30.25,12.0]");
    }

    @Test
    void jsonSaysHowHighWhatFlewIsAndWas() throws Exception {
        JsonNode boats =
                new ObjectMapper().readTree(file("report.json", REPORT)).get("boats");

        assertThat(boats.get(0).has("altM")).isFalse();
        assertThat(boats.get(1).path("altM").asDouble()).isEqualTo(12);
        assertThat(boats.get(1).path("highestAltM").asDouble()).isEqualTo(30.25);
    }
}
