package org.sami.crw.report.file;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.awt.image.BufferedImage;
import java.lang.reflect.RecordComponent;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sami.crw.operator.mission.Wait;
import org.sami.crw.report.ReadingResult;
import org.sami.crw.report.ReportText;
import org.sami.crw.report.RunReport;
import org.sami.crw.report.SampleReport;
import org.sami.palette.IdentityMark;
import org.sami.palette.Theme;

class ReportFolderTest {
    @TempDir
    Path folder;

    @Test
    void writesEveryFile() throws Exception {
        new ReportFolder(folder).write(SampleReport.of(3, 12));

        try (var files = Files.list(folder)) {
            assertThat(files.map(f -> f.getFileName().toString()))
                    .containsExactlyInAnyOrder(
                            "report.json",
                            "boats.csv",
                            "locations.csv",
                            "approaches.csv",
                            "firings.csv",
                            "tracks.csv",
                            "readings.csv",
                            "decisions.csv",
                            "interrupts.csv",
                            "tasks.csv",
                            "messages.csv",
                            "phases.csv",
                            "operator.csv",
                            "run.gpx",
                            "run.kml",
                            "run.geojson",
                            "map.png");
        }
    }

    @Test
    void jsonHasTheMembersThatProgramsRelyOn() throws Exception {
        JsonNode json = new ObjectMapper().readTree(ReportJson.text(SampleReport.of(3, 12)));

        assertThat(json.fieldNames())
                .toIterable()
                .contains(
                        "outcome",
                        "simulatedSeconds",
                        "wallSeconds",
                        "clicks",
                        "firings",
                        "seed",
                        "locationsVisited",
                        "boats",
                        "interrupts",
                        "resumedFrom",
                        "runHash",
                        "plan",
                        "mission");
        assertThat(json.get("outcome").asText()).isEqualTo("aborted");
        assertThat(json.get("simulatedSeconds").asText()).isEqualTo("754.3");
        assertThat(json.get("locationsVisited").asInt()).isEqualTo(11);
        assertThat(json.get("boats").get(0).get("distanceM").asText()).isEqualTo("1500");
        assertThat(json.get("interrupts").get(0).toString())
                .isEqualTo("{\"name\":\"Alarm\",\"boat\":\"boat1\",\"trigger\":\"time\",\"pressedAt\":65,\"presses\":2,"
                        + "\"taken\":true,\"takenAt\":67}");
    }

    @Test
    void rowsHaveTheirMembersInTheirOrder() throws Exception {
        JsonNode json = new ObjectMapper().readTree(ReportJson.text(SampleReport.of(3, 12)));

        assertThat(json.get("boats").get(0).toString())
                .isEqualTo(
                        "{\"id\":\"boat1\",\"link\":\"in-process\",\"bootId\":\"boot1\",\"linkLost\":0,\"linkBack\":0,\"uploads\":"
                                + "{\"sent\":3,\"acknowledged\":3,\"readBackEqual\":2,\"failed\":1},\"distanceM\":1500,\"batteryPercent\":33.33,"
                                + "\"recharges\":0,\"why\":\"it does what it should\"}");
        assertThat(json.get("locations").get(0).toString())
                .isEqualTo(
                        "{\"number\":1,\"latDeg\":40.0013469,\"lonDeg\":-79.9983715,\"visited\":true,\"visitedAt\":60,"
                                + "\"visitedBy\":\"boat1\",\"reported\":true,\"reportedAt\":60,\"reportedBy\":\"boat1\"}");
        assertThat(json.get("decisions").get(0).toString())
                .isEqualTo(
                        "{\"id\":1,\"type\":\"OperatorApprove\",\"openedAt\":0,\"closedAt\":5,\"by\":\"operator\",\"clicks\":1}");
        assertThat(json.get("notes").get(0).toString())
                .isEqualTo("{\"at\":70,\"kind\":\"late\",\"mission\":1,\"message\":\"An answer came late.\"}");
        assertThat(List.of(Wait.class.getRecordComponents()).stream().map(RecordComponent::getName))
                .containsExactly("missions", "plan", "place", "tokens", "occurrence", "transitions");
        assertThat(List.of(Wait.BlockedTransition.class.getRecordComponents()).stream()
                        .map(RecordComponent::getName))
                .containsExactly("name", "reasons");
    }

    @Test
    void roundNumbersHaveNoExponent() {
        assertThat(ReportJson.text(SampleReport.of(3, 12)))
                .contains("\"distanceM\" : 1500")
                .doesNotContain("E+");
    }

    @Test
    void tablesQuoteWhatSpreadsheetsWouldSplit() throws Exception {
        new ReportFolder(folder).write(SampleReport.of(3, 12));

        List<String> decisions = Files.readAllLines(folder.resolve("decisions.csv"));
        assertThat(decisions).hasSize(2);
        assertThat(decisions.get(1))
                .isEqualTo("1,1,OperatorApprove,\"Say \"\"yes\"\", or no\",0.000,5.000,operator,yes,1");
    }

    @Test
    void tracksHaveOneRowForEachPointOfEachBoat() throws Exception {
        RunReport report = SampleReport.of(3, 12);

        new ReportFolder(folder).write(report);

        int points = report.boats().stream().mapToInt(b -> b.track().size()).sum();
        assertThat(Files.readAllLines(folder.resolve("tracks.csv"))).hasSize(points + 1);
    }

    @Test
    void readingsHaveOneRowForEachValueAndASummaryForEachChannel() throws Exception {
        RunReport report = SampleReport.of(3, 12)
                .withReadings(List.of(
                        new ReadingResult(1500, "boat1", "water", "ph", List.of(7.5), "", 45, 10),
                        new ReadingResult(2500, "boat2", "adcp", "profile", List.of(0.25, 0.75), "m/s", 45, 10),
                        new ReadingResult(2500, "boat2", "water", "ph", List.of(8.0), "", 45, 10)));

        new ReportFolder(folder).write(report);

        assertThat(Files.readAllLines(folder.resolve("readings.csv")))
                .containsExactly(
                        "boat,at_s,sensor,channel,number,value,unit,lat_deg,lon_deg",
                        "boat1,1.500,water,ph,1,7.500000,,45.0000000,10.0000000",
                        "boat2,2.500,adcp,profile,1,0.250000,m/s,45.0000000,10.0000000",
                        "boat2,2.500,adcp,profile,2,0.750000,m/s,45.0000000,10.0000000",
                        "boat2,2.500,water,ph,1,8.000000,,45.0000000,10.0000000");
        JsonNode json = new ObjectMapper().readTree(ReportJson.text(report));
        assertThat(json.get("readings").toString())
                .isEqualTo("[{\"sensor\":\"water\",\"channel\":\"ph\",\"unit\":\"\",\"count\":2,"
                        + "\"least\":7.5,\"mean\":7.75,\"most\":8},"
                        + "{\"sensor\":\"adcp\",\"channel\":\"profile\",\"unit\":\"m/s\",\"count\":1,"
                        + "\"least\":0.25,\"mean\":0.5,\"most\":0.75}]");
        assertThat(ReportText.text(report)).containsPattern("adcp profile +1 +0.25 +0.50 +0.75 +m/s");
    }

    @Test
    void pictureShowsEveryBoatsColour() throws Exception {
        new ReportFolder(folder).write(SampleReport.of(5, 30));

        BufferedImage picture = ImageIO.read(folder.resolve("map.png").toFile());
        Set<Integer> colors = new HashSet<>();
        for (int x = 0; x < 1060; x++) {
            for (int y = 100; y < 1000; y++) {
                colors.add(picture.getRGB(x, y) & 0xFFFFFF);
            }
        }
        for (int boat = 0; boat < 5; boat++) {
            assertThat(colors)
                    .contains(new IdentityMark(boat).color(Theme.LIGHT).getRGB() & 0xFFFFFF);
        }
    }

    @Test
    void pictureOfAFleetThatNeverMovedCanBeDrawn() throws Exception {
        RunReport report = SampleReport.of(1, 0);

        new ReportFolder(folder).write(report);

        assertThat(ImageIO.read(folder.resolve("map.png").toFile()).getWidth()).isPositive();
    }

    @Test
    void textNamesBoatsAndNotes() {
        assertThat(ReportText.text(SampleReport.of(3, 12)))
                .contains("11 of 12")
                .contains("12 min 34 s")
                .contains("boat3")
                .contains("An answer came late.")
                .contains("aborted: by the user");
    }
}
