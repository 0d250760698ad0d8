package org.sami.crw.sim.run;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.locationtech.jts.geom.Coordinate;
import org.locationtech.jts.geom.Envelope;
import org.locationtech.jts.geom.Geometry;
import org.locationtech.jts.geom.GeometryFactory;
import org.sami.boat.server.vehicle.LocalFrame;
import org.sami.crw.decision.AnswersFileReader;
import org.sami.crw.report.BoatResult;
import org.sami.crw.report.LocationResult;
import org.sami.crw.report.RunOutcome;
import org.sami.crw.report.RunReport;
import org.sami.crw.service.water.SafetyMargin;
import org.sami.crw.sim.hull.Conditions;
import org.sami.crw.sim.resume.ResumedJournal;
import org.sami.crw.sim.resume.RunRecord;
import org.sami.crw.sim.resume.WrittenJournal;
import org.sami.crw.sim.run.settings.FleetSettings;
import org.sami.crw.sim.run.settings.InitialCharges;
import org.sami.crw.sim.run.settings.RunPlan;
import org.sami.crw.sim.run.settings.RunSettings;
import org.sami.crw.sim.run.settings.Site;
import org.sami.spn.json.ProjectReader;
import org.sami.spn.json.ProjectWriter;
import org.sami.spn.model.Project;
import org.sami.spn.value.GeoPoint;

/** Whole missions around a rock in the middle of the water, which the allocation is to avoid: measured on the boats' true tracks. */
@Tag("long")
class ClearWaysRunTest {
    private static final double HALF_M = 60;
    private static final GeometryFactory FACTORY = new GeometryFactory();
    private static final Geometry ROCK = FACTORY.toGeometry(new Envelope(-HALF_M, HALF_M, -HALF_M, HALF_M));
    /** The last field of the requests of the plans' texts: allocations; areas to explore and assemblies. */
    private static final List<String> LAST_FIELDS = List.of(
            "\"fields\": {\"locations\": {\"variable\": \"@locations\"}}",
            "\"spacing\": {\"variable\": \"@spacing\"}}",
            "\"location\": {\"variable\": \"@station\"}, \"spacing\": {\"value\": 5}}");

    @TempDir
    Path folder;

    @ParameterizedTest
    @CsvSource({
        "clv, ''",
        "clv-interrupts, alarm@60",
        "clv-interrupts, recharge:2@90",
        "clv-interrupts, recharge@battery"
    })
    void inCalmWaterNoBoatEntersTheRockOnWhicheverWay(String plan, String interrupt) {
        RunReport report = run(plan, interrupt, Conditions.CALM, 1);

        assertThat(report.result().outcome()).as(report.result().reason()).isEqualTo(RunOutcome.ENDED);
        assertThat(report.locations()).hasSize(8).allMatch(LocationResult::visited);
        assertThat(deepestM(report)).isZero();
    }

    @ParameterizedTest
    @CsvSource({
        "explore-area, ''",
        "explore-team, battery swap:1@180",
        "deploy-and-station-keep, end station keeping@400",
        "clv-reassign, recharge:2@60"
    })
    void inCalmWaterNoBoatEntersTheRockAlsoOnLanesToAnAssemblyAndToItsQuay(String plan, String interrupt) {
        RunReport report = run(plan, interrupt, Conditions.CALM, 1);

        assertThat(report.result().outcome()).as(report.result().reason()).isEqualTo(RunOutcome.ENDED);
        assertThat(report.distanceM()).isGreaterThan(300);
        assertThat(deepestM(report)).isZero();
    }

    @Test
    void missionThatIsTakenUpAgainKeepsClear() throws IOException {
        Project project = project("clv-interrupts");
        RunSettings settings = settings("clv-interrupts", "alarm@60", Conditions.CALM, 1);
        Path file = folder.resolve("clv.journal");
        RunRecord record = new RunRecord(
                settings,
                "clv-interrupts",
                new ProjectWriter(TestRuns.LIBRARY.vocabulary()).text(project),
                TestRuns.LIBRARY.files().texts(),
                Optional.empty(),
                Optional.empty(),
                Optional.empty());
        try (WrittenJournal written = WrittenJournal.create(file, record)) {
            CrashingJournal crashing = new CrashingJournal(written, 14);
            assertThatExceptionOfType(CrashingJournal.Crash.class).isThrownBy(() -> run(project, settings, crashing));
        }

        try (ResumedJournal journal = ResumedJournal.open(file)) {
            RunReport report = run(project, settings, journal);

            assertThat(report.result().resumedFrom()).isPresent();
            assertThat(report.result().outcome()).as(report.result().reason()).isEqualTo(RunOutcome.ENDED);
            assertThat(deepestM(report)).isZero();
        }
    }

    @ParameterizedTest
    @CsvSource({"clv-interrupts, 1", "clv-interrupts, 2", "explore-area, 14", "explore-area, 19"})
    void inTheFieldNoBoatComesDeeperIntoTheRockThanWasAnnounced(String plan, long seed) {
        RunReport report = run(plan, plan.startsWith("clv") ? "alarm@60" : "", Conditions.FIELD, seed);

        assertThat(report.result().outcome()).as(report.result().reason()).isEqualTo(RunOutcome.ENDED);
        double announcedM = report.notes().stream()
                .map(note -> note.message().replaceAll(".* so up to ([0-9.]+) m inside.*", "$1"))
                .filter(words -> words.matches("[0-9.]+"))
                .mapToDouble(Double::parseDouble)
                .max()
                .orElse(0);
        assertThat(report.map().announcedM()).hasValue(announcedM);
        assertThat(deepestM(report)).isLessThanOrEqualTo(announcedM);
        double keptM = new SafetyMargin(Conditions.FIELD.crossTrackError()).pathM();
        assertThat(announcedM)
                .as("there is room for the margin everywhere")
                .isPositive()
                .isLessThan(new SafetyMargin(Conditions.FIELD.crossTrackError()).insideM(keptM) + 0.5);
    }

    private static RunReport run(String plan, String interrupt, Conditions conditions, long seed) {
        return run(project(plan), settings(plan, interrupt, conditions, seed), RunJournal.none());
    }

    private static RunReport run(Project project, RunSettings settings, RunJournal journal) {
        RunPlan plan = new RunPlan(
                TestRuns.LIBRARY.vocabulary(),
                project,
                project.plan(settings.plan()).orElseThrow());
        return new InProcessRun(
                        plan,
                        settings,
                        AnswersFileReader.read(settings.answers(), TestRuns.LIBRARY.vocabulary())
                                .orThrow(),
                        journal)
                .run(Pacer.UNPACED, RunObserver.NONE);
    }

    private static RunSettings settings(String plan, String interrupt, Conditions conditions, long seed) {
        String answers = """
            {"format": "crw-answers", "version": 1, "rules": [
             {"event": "OperatorCreateLocations", "answer": {"values": {"locations": [%s]}}}]}\
            """.formatted(locations());
        FleetSettings fleet = new FleetSettings(3, 8, 400, seed).on(conditions);
        RunSettings settings = RunSettings.of(plan, plan, fleet)
                .limitMillis(7_200_000)
                .answers(answers)
                .interrupts(interrupt.isEmpty() ? List.of() : List.of(interrupt))
                .build();
        return interrupt.endsWith("battery")
                ? settings.withFleet(fleet.with(InitialCharges.parse("100,32,100")))
                : settings;
    }

    private static Project project(String plan) {
        String text = text(plan);
        for (String last : LAST_FIELDS) {
            text = text.replace(
                    last, last.substring(0, last.length() - 1) + ", \"avoid\": {\"value\": " + rock() + "}}");
        }
        return new ProjectReader(TestRuns.LIBRARY.vocabulary()).read(text).orThrow();
    }

    private static String text(String plan) {
        try (InputStream in =
                ClearWaysRunTest.class.getResourceAsStream("/org/sami/domain/crw/plans/" + plan + ".json")) {
            return new String(in.readAllBytes(), StandardCharsets.UTF_8);
        } catch (IOException e) {
            throw new IllegalStateException(e);
        }
    }

    private static String rock() {
        return "[{\"outline\": [" + point(-HALF_M, -HALF_M) + ", " + point(HALF_M, -HALF_M) + ", "
                + point(HALF_M, HALF_M) + ", " + point(-HALF_M, HALF_M) + "]}]";
    }

    /** Around the rock, in turn on opposite sides. */
    private static String locations() {
        StringBuilder locations = new StringBuilder();
        for (int i = 0; i < 8; i++) {
            double angle = Math.PI * (i * 3 % 8) / 4 + 0.2;
            locations.append(i == 0 ? "" : ", ").append(point(100 * Math.cos(angle), 100 * Math.sin(angle)));
        }
        return locations.toString();
    }

    private static String point(double eastM, double northM) {
        GeoPoint centre = Site.USUAL.centreInProcess();
        LocalFrame frame = new LocalFrame(centre.latDeg(), centre.lonDeg());
        return String.format(
                Locale.ROOT,
                "{\"lat\": %.9f, \"lon\": %.9f}",
                frame.latDeg(eastM, northM),
                frame.lonDeg(eastM, northM));
    }

    private static double deepestM(RunReport report) {
        double deepestM = 0;
        for (BoatResult boat : report.boats()) {
            Geometry track = FACTORY.createLineString(boat.track().stream()
                    .map(point -> new Coordinate(point.eastM(), point.northM()))
                    .toArray(Coordinate[]::new));
            for (Coordinate place : track.intersection(ROCK).getCoordinates()) {
                deepestM = Math.max(deepestM, ROCK.getBoundary().distance(FACTORY.createPoint(place)));
            }
        }
        return deepestM;
    }
}
