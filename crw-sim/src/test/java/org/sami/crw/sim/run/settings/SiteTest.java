package org.sami.crw.sim.run.settings;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import java.util.Optional;
import java.util.OptionalLong;
import org.junit.jupiter.api.Test;
import org.sami.crw.report.MapPoint;
import org.sami.crw.report.RunReport;
import org.sami.crw.report.TrackPoint;
import org.sami.crw.service.Geodesy;
import org.sami.crw.sim.run.TestRuns;
import org.sami.spn.json.ProjectReader;
import org.sami.spn.model.Project;
import org.sami.spn.value.GeoPoint;

class SiteTest {
    private static final RunPlan AWAY = away();

    @Test
    void nothingThatAPlanNamesMovesARun() {
        RunReport narrow = run(AWAY, settings(AWAY, 100, Site.USUAL));
        RunReport wide = run(AWAY, settings(AWAY, 2000, Site.USUAL));

        assertThat(narrow.header().place().centre()).isEqualTo(new MapPoint(45.7, 10.72, 0, 0));
        assertThat(wide.header().place().centre()).isEqualTo(new MapPoint(45.7, 10.72, 0, 0));
    }

    @Test
    void aRunIsWhereItIsToldToBe() {
        GeoPoint centre = GeoPoint.of(-33.85, 151.2);
        RunPlan plan = TestRuns.plan("clv");

        RunReport report = run(plan, settings(plan, 200, Site.at(centre)));

        MapPoint quay = report.header().place().quay().orElseThrow();
        TrackPoint start = report.boats().get(1).track().get(0); // the middle one of three
        assertThat(report.header().place().centre()).isEqualTo(new MapPoint(-33.85, 151.2, 0, 0));
        assertThat(quay.northM()).isCloseTo(-120, org.assertj.core.data.Offset.offset(1e-6));
        assertThat(distanceM(quay, start)).isLessThan(0.01);
        assertThat(report.locations())
                .isNotEmpty()
                .allSatisfy(l -> assertThat(Geodesy.distanceM(centre, GeoPoint.of(l.latDeg(), l.lonDeg())))
                        .isLessThan(150));
    }

    @Test
    void boatsLieAtTheQuayThatIsGiven() {
        GeoPoint quay = GeoPoint.of(45.7012, 10.7213);
        RunPlan plan = TestRuns.plan("clv");

        RunReport report = run(plan, settings(plan, 200, new Site(Optional.empty(), Optional.of(quay))));

        TrackPoint start = report.boats().get(1).track().get(0);
        assertThat(Geodesy.distanceM(quay, GeoPoint.of(start.latDeg(), start.lonDeg())))
                .isLessThan(0.01);
        assertThat(report.header().place().quay().orElseThrow().latDeg()).isEqualTo(45.7012);
    }

    @Test
    void aQuayBeyondTheWaterIsRefused() {
        assertThatThrownBy(() -> new Site(Optional.empty(), Optional.of(GeoPoint.of(46.0, 10.72))))
                .hasMessageContaining("46.0000000,10.7200000")
                .hasMessageContaining("45.7000000,10.7200000");
    }

    @Test
    void placesBeyondTheWaterAreFound() {
        PlanLocations places = new PlanLocations(AWAY.project(), AWAY.plan(), List.of());

        assertThat(places.beyond(Site.USUAL_CENTRE)).isEmpty();
        assertThat(places.beyond(GeoPoint.of(46.0, 10.72))).contains(GeoPoint.of(45.703, 10.72));
        assertThat(places.suitable(GeoPoint.of(46.0, 10.72), 600)).isEqualTo(GeoPoint.of(45.703, 10.72));
    }

    private static double distanceM(MapPoint a, TrackPoint b) {
        return Geodesy.distanceM(GeoPoint.of(a.latDeg(), a.lonDeg()), GeoPoint.of(b.latDeg(), b.lonDeg()));
    }

    private static RunReport run(RunPlan plan, RunSettings settings) {
        return TestRuns.run(plan, settings.withLimit(OptionalLong.of(20_000)));
    }

    private static RunSettings settings(RunPlan plan, double areaM, Site site) {
        FleetSettings fleet = new FleetSettings(3, 4, areaM, 1).at(site);
        RunSettings usual = TestRuns.settings(plan, 3, 4, 1);
        return RunSettings.of(usual.plan(), usual.mission(), fleet)
                .speed(usual.speed())
                .limit(usual.limitMillis())
                .parameters(usual.parameters())
                .answerAfterMillis(usual.answerAfterMillis())
                .answers(usual.answers())
                .build();
    }

    /** A plan that names a point 334 m north of the usual centre. */
    private static RunPlan away() {
        String text = TestRuns.text("allocation-at-once.json").replace("\"lat\": 45.7,", "\"lat\": 45.703,");
        Project project =
                new ProjectReader(TestRuns.LIBRARY.vocabulary()).read(text).orThrow();
        return new RunPlan(
                TestRuns.LIBRARY.vocabulary(), project, project.plans().get(0));
    }
}
