package org.sami.crw.sim.tcp;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.sami.boat.link.StartWaypoints;
import org.sami.boat.server.testing.Await;
import org.sami.crw.cli.CommandResult;
import org.sami.crw.cli.CrwProcess;
import org.sami.crw.service.Geodesy;
import org.sami.crw.service.water.Water;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPoint;

/** A run over TCP around a rock, killed and taken up: in still water with exact instruments, so that what boats tell of themselves is the truth. */
@Tag("process")
@Timeout(900)
class ClearWaysTakenUpTest {
    private static final String ALLOCATION = "\"fields\": {\"locations\": {\"variable\": \"@locations\"}}";
    private static final GeoPoint QUAY = GeoPoint.of(BoatProcesses.latDeg(), 10.9);

    /** Between the boats at the quay, the second of which lies 8 m east of the first, and where they are to go. */
    private static final List<GeoPoint> ROCK = List.of(at(-8, 5), at(14, 5), at(14, 9), at(-8, 9));

    @TempDir
    private Path folder;

    private static GeoPoint at(double eastM, double northM) {
        return Geodesy.offset(QUAY, eastM, northM);
    }

    private static String json(GeoPoint point) {
        return String.format(Locale.ROOT, "{\"lat\": %.9f, \"lon\": %.9f}", point.latDeg(), point.lonDeg());
    }

    @Test
    @Execution(ExecutionMode.CONCURRENT)
    void boatsOfARunThatIsTakenUpKeepClearOfTheRock() throws Exception {
        Path journal = folder.resolve("journal");
        Path report = folder.resolve("report");
        try (BoatProcesses fleet = new BoatProcesses(folder).with("anna", "bert")) {
            killUnderWay(fleet, journal);

            CommandResult resumed = CommandResult.crw("resume", journal.toString(), "--report", report.toString());

            assertThat(resumed.exitCode()).as(resumed.err()).isZero();
        }
        Water water = Water.of(QUAY, List.of(new GeoArea(ROCK, List.of())), Optional.empty());
        for (String boat : List.of("anna", "bert")) {
            List<GeoPoint> track = track(report, boat);
            assertThat(Geodesy.lengthM(track.get(0), track))
                    .as("around the rock")
                    .isGreaterThan(20);
            assertThat(water.clearanceM(track)).as(boat).isPositive();
        }
    }

    private void killUnderWay(BoatProcesses fleet, Path journal) throws Exception {
        List<String> mission = List.of(
                "run",
                plan().toString(),
                "--connect",
                fleet.addresses(),
                "--answers",
                answers().toString(),
                "--locations",
                "2",
                "--answer-after",
                "0.2",
                "--journal",
                journal.toString());
        try (CrwProcess run = CrwProcess.start(folder, mission)) {
            for (String boat : List.of("anna", "bert")) {
                Await.until(
                        boat + " is under way",
                        () -> fleet.log(boat).stream().anyMatch(entry -> entry.command() instanceof StartWaypoints));
            }
            run.kill();
        }
    }

    /** The shipped plan, with the rock as what the allocation avoids. */
    private Path plan() throws Exception {
        try (InputStream in = getClass().getResourceAsStream("/org/sami/domain/crw/plans/clv.json")) {
            String text = new String(in.readAllBytes(), StandardCharsets.UTF_8);
            String outline = String.join(
                    ", ", ROCK.stream().map(ClearWaysTakenUpTest::json).toList());
            String avoiding = ALLOCATION.substring(0, ALLOCATION.length() - 1)
                    + ", \"avoid\": {\"value\": [{\"outline\": [" + outline + "]}]}}";
            assertThat(text).contains(ALLOCATION);
            return Files.writeString(folder.resolve("clv.json"), text.replace(ALLOCATION, avoiding));
        }
    }

    private Path answers() throws Exception {
        return Files.writeString(folder.resolve("answers.json"), """
                {"format": "crw-answers", "version": 1, "rules": [
                 {"event": "OperatorCreateLocations", "answer": {"values": {"locations": [%s, %s]}}}]}""".formatted(json(at(0, 13)), json(at(8, 13))));
    }

    private static List<GeoPoint> track(Path report, String boat) throws Exception {
        List<String> lines = Files.readAllLines(report.resolve("tracks.csv"));
        List<String> columns = List.of(lines.get(0).split(","));
        List<GeoPoint> track = new ArrayList<>();
        for (String line : lines.subList(1, lines.size())) {
            List<String> row = List.of(line.split(","));
            if (row.get(columns.indexOf("boat")).equals(boat)) {
                track.add(GeoPoint.of(
                        Double.parseDouble(row.get(columns.indexOf("lat_deg"))),
                        Double.parseDouble(row.get(columns.indexOf("lon_deg")))));
            }
        }
        return track;
    }
}
