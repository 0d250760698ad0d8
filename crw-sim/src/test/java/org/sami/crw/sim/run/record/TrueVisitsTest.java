package org.sami.crw.sim.run.record;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.sami.crw.report.BoatResult;
import org.sami.crw.report.LocationResult;
import org.sami.crw.report.ReportText;
import org.sami.crw.report.RunReport;
import org.sami.crw.report.TrackPoint;
import org.sami.crw.sim.hull.Conditions;
import org.sami.crw.sim.run.TestRuns;
import org.sami.crw.sim.run.settings.RunPlan;
import org.sami.crw.sim.run.settings.RunSettings;

/** Where boats truly were, next to what they report. */
class TrueVisitsTest {
    private final VisitRecorder reported = new VisitRecorder();
    private final TrueVisits visits = new TrueVisits(reported);

    @Test
    void boatThatPassedBetweenTwoLooksWasThere() {
        reported.add(45, 10, 0, 0);

        visits.look(0, at(-10, 1));
        visits.look(200, at(10, 1));

        assertThat(visits.locations().get(0).visitedAtMillis()).hasValue(200);
        assertThat(nearestM()).isEqualTo(1, within(1e-9));
    }

    @Test
    void boatThatKeptFartherAwayWasNotThereWhateverItReports() {
        reported.add(45, 10, 0, 0);
        reported.visited(45, 10, 100, "anna");

        visits.look(0, at(-10, 3.01));
        visits.look(200, at(10, 3.01));

        LocationResult location = visits.locations().get(0);
        assertThat(location.visited()).isFalse();
        assertThat(location.reported()).contains(new LocationResult.Visit(100, "anna"));
        assertThat(nearestM()).isEqualTo(3.01, within(1e-9));
    }

    @ParameterizedTest
    @ValueSource(doubles = {-600, -0.5, 0, 24.9, 1000})
    void anyPlaceIsMeasuredFromWhenItIsGiven(double eastM) {
        visits.look(0, at(eastM, 100));
        reported.add(45, 10, eastM + 2, 101);

        visits.look(200, at(eastM, 100));
        visits.look(400, at(eastM + 24, 101));

        double byLineM = (24 - 2) / Math.hypot(24, 1); // from a point to the line between the two looks
        assertThat(nearestM()).isEqualTo(byLineM, within(1e-6));
        assertThat(visits.locations().get(0).visited()).isTrue();
    }

    @Test
    void locationThatNoBoatCameNearHasNoDistance() {
        reported.add(45, 10, 0, 0);

        visits.look(0, at(40, 0));

        assertThat(visits.locations().get(0).truth().orElseThrow().nearestM()).isEmpty();
    }

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3})
    void inTheFieldReportsAreToldApartFromWhatTracksShow(long seed) {
        RunReport report = run(Conditions.FIELD, seed);

        assertThat(report.locationsReported()).isEqualTo(12);
        int near = 0;
        for (LocationResult location : report.locations()) {
            double byTrackM = nearestM(report, location);
            double nearestM = location.truth().orElseThrow().nearestM().orElseThrow();
            assertThat(nearestM).isEqualTo(byTrackM, within(0.3)); // a track is right to 0.2 m
            near += nearestM <= 3 ? 1 : 0;
        }
        assertThat(report.locationsVisited()).isEqualTo(near);
        assertThat(ReportText.text(report))
                .contains("locations visited   12 of 12, as boats reported")
                .contains("  truly within 3 m  " + near + " of 12, farthest ");
    }

    @Test
    void inCalmWaterReportsAreTrue() {
        RunReport report = run(Conditions.CALM, 1);

        assertThat(report.locationsReported()).isEqualTo(12);
        assertThat(report.locationsVisited()).isEqualTo(12);
        assertThat(report.locations())
                .allMatch(location -> location.truth().orElseThrow().nearestM().orElseThrow() < 1);
    }

    private static RunReport run(Conditions water, long seed) {
        RunPlan plan = TestRuns.plan("clv");
        RunSettings settings = TestRuns.settings(plan, 3, 12, seed);
        return TestRuns.run(plan, settings.withFleet(settings.fleet().on(water)));
    }

    private double nearestM() {
        return visits.locations().get(0).truth().orElseThrow().nearestM().orElseThrow();
    }

    private static double nearestM(RunReport report, LocationResult location) {
        double nearestM = Double.MAX_VALUE;
        for (BoatResult boat : report.boats()) {
            List<TrackPoint> track = boat.track();
            for (int i = 1; i < track.size(); i++) {
                for (double part = 0; part <= 1; part += 0.02) {
                    double eastM =
                            track.get(i - 1).eastM() * (1 - part) + track.get(i).eastM() * part;
                    double northM = track.get(i - 1).northM() * (1 - part)
                            + track.get(i).northM() * part;
                    nearestM = Math.min(nearestM, Math.hypot(eastM - location.eastM(), northM - location.northM()));
                }
            }
        }
        return nearestM;
    }

    private static List<BoatState> at(double eastM, double northM) {
        return List.of(new BoatState("anna", eastM, northM, 45, 10, 1, 100, 0, 0, 0));
    }
}
