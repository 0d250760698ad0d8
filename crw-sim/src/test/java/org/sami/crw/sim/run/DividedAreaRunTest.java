package org.sami.crw.sim.run;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.sami.boat.server.vehicle.LocalFrame;
import org.sami.crw.report.BoatResult;
import org.sami.crw.report.Exploration;
import org.sami.crw.report.RunOutcome;
import org.sami.crw.report.RunReport;
import org.sami.crw.report.TrackPoint;
import org.sami.crw.sim.run.settings.FleetSettings;
import org.sami.crw.sim.run.settings.RunPlan;
import org.sami.crw.sim.run.settings.RunSettings;
import org.sami.crw.sim.run.settings.Site;
import org.sami.spn.json.ProjectReader;
import org.sami.spn.json.ProjectWriter;
import org.sami.spn.model.Project;
import org.sami.spn.value.GeoPoint;

/**
 * An area that what is to be avoided cuts in two: measured on the boats' true tracks. A wall leads from the north to the south of the water that boats may
 * not leave, and through the middle of the area; three boats begin 5 m from one another, south of it.
 */
class DividedAreaRunTest {
    private static final double AREA_M = 150;
    private static final double WATER_M = 250; // to each side
    private static final double WALL_M = 2; // its width
    private static final Pattern UNREACHED =
            Pattern.compile(".*no boat can reach (\\d+) m² near [0-9.]+,([0-9.]+).*", Pattern.DOTALL);

    @Test
    void eachPartIsCoveredByTheBoatsOnItsSide() {
        double wallEastM = 1.5; // east of the second boat, west of the third

        RunReport report = run(wallEastM);

        Exploration explored = explored(report);
        assertThat(explored.percent(explored.left().trueM2().orElseThrow())).isGreaterThan(99.5);
        List<BoatResult> boats = report.boats();
        assertThat(List.of(boats.get(0), boats.get(1)))
                .allSatisfy(boat -> assertThat(boat.track()).allMatch(point -> point.eastM() < wallEastM));
        assertThat(boats.get(2).track()).allMatch(point -> point.eastM() > wallEastM + WALL_M);
        assertThat(boats).allMatch(boat -> boat.distanceM() > AREA_M);
    }

    @Test
    void partThatNoBoatCanReachIsNamedAndTheOtherIsCovered() {
        double wallEastM = 10;

        RunReport report = run(wallEastM);

        Matcher told = report.notes().stream()
                .map(note -> UNREACHED.matcher(note.message()))
                .filter(Matcher::matches)
                .findFirst()
                .orElseThrow();
        double eastPartM2 = (AREA_M / 2 - wallEastM - WALL_M) * AREA_M;
        assertThat(Double.parseDouble(told.group(1))).isCloseTo(eastPartM2, within(0.03 * eastPartM2));
        assertThat(Double.parseDouble(told.group(2)))
                .isGreaterThan(at(wallEastM, 0).lonDeg());
        Exploration explored = explored(report);
        assertThat(explored.left().trueM2().orElseThrow()).isCloseTo(eastPartM2, within(0.01 * explored.areaM2()));
        assertThat(report.boats()).flatExtracting(BoatResult::track).allMatch(point -> point.eastM() < wallEastM);
    }

    private static Exploration explored(RunReport report) {
        assertThat(report.result().outcome()).as(report.result().reason()).isEqualTo(RunOutcome.ENDED);
        assertThat(report.boats())
                .flatExtracting(BoatResult::track)
                .extracting(TrackPoint::northM)
                .allMatch(north -> Math.abs(north) < WATER_M);
        assertThat(report.map().explorations()).hasSize(1);
        return report.map().explorations().get(0);
    }

    private static RunReport run(double wallEastM) {
        String limits = ", \"avoid\": {\"value\": [" + box(wallEastM, -2 * WATER_M, wallEastM + WALL_M, 2 * WATER_M)
                + "]}, \"within\": {\"value\": " + box(-WATER_M, -WATER_M, WATER_M, WATER_M) + "}";
        Project library = TestRuns.LIBRARY.projectOf("explore-area").orElseThrow();
        String spacing = "\"spacing\": {\"variable\": \"@spacing\"}";
        String text = new ProjectWriter(TestRuns.LIBRARY.vocabulary()).text(library);
        Project project = new ProjectReader(TestRuns.LIBRARY.vocabulary())
                .read(text.replace(spacing, spacing + limits))
                .orThrow();
        RunPlan plan = new RunPlan(
                TestRuns.LIBRARY.vocabulary(),
                project,
                project.plan("explore-area").orElseThrow());
        return TestRuns.run(
                plan,
                RunSettings.of(plan.plan().id(), plan.plan().name(), new FleetSettings(3, 1, AREA_M, 1))
                        .limitMillis(7_200_000)
                        .parameters(Map.of("@spacing", "10"))
                        .build());
    }

    private static String box(double westM, double southM, double eastM, double northM) {
        return "{\"outline\": [" + point(westM, southM) + ", " + point(eastM, southM) + ", " + point(eastM, northM)
                + ", " + point(westM, northM) + "]}";
    }

    private static String point(double eastM, double northM) {
        GeoPoint point = at(eastM, northM);
        return String.format(Locale.ROOT, "{\"lat\": %.9f, \"lon\": %.9f}", point.latDeg(), point.lonDeg());
    }

    private static GeoPoint at(double eastM, double northM) {
        GeoPoint centre = Site.USUAL.centreInProcess();
        LocalFrame frame = new LocalFrame(centre.latDeg(), centre.lonDeg());
        return GeoPoint.of(frame.latDeg(eastM, northM), frame.lonDeg(eastM, northM));
    }
}
