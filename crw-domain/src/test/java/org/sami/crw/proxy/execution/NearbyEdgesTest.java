package org.sami.crw.proxy.execution;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.function.Predicate;
import org.junit.jupiter.api.Test;
import org.locationtech.jts.geom.Coordinate;
import org.sami.boat.link.NoGoEdge;
import org.sami.boat.link.NoGoEdges;
import org.sami.crw.service.Geodesy;
import org.sami.crw.service.LocalPlane;
import org.sami.crw.service.water.Areas;
import org.sami.crw.service.water.CrossTrackError;
import org.sami.crw.service.water.SafetyMargin;
import org.sami.crw.service.water.Water;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPoint;

/** Which edges a base tells a boat. */
class NearbyEdgesTest {
    private static final GeoPoint ORIGIN = GeoPoint.of(45.4, 10.9);

    private static GeoPoint at(double eastM, double northM) {
        return Geodesy.offset(ORIGIN, eastM, northM);
    }

    private static GeoArea area(double westM, double southM, double eastM, double northM) {
        return new GeoArea(
                List.of(at(westM, southM), at(eastM, southM), at(eastM, northM), at(westM, northM)), List.of());
    }

    private static NearbyEdges avoiding(GeoArea... areas) {
        return new NearbyEdges(
                Water.of(ORIGIN, List.of(areas), Optional.empty()).drivenWith(CrossTrackError.CALM));
    }

    private static double lengthM(NoGoEdge edge) {
        return Geodesy.distanceM(
                GeoPoint.of(edge.fromLatDeg(), edge.fromLonDeg()), GeoPoint.of(edge.toLatDeg(), edge.toLonDeg()));
    }

    @Test
    void edgesNearTheBoatAreToldAndHowFarItKeepsOffThem() {
        NoGoEdges told = avoiding(area(10, -2, 14, 2)).near(ORIGIN).orElseThrow();

        assertThat(told.keepM()).isEqualTo(new SafetyMargin(CrossTrackError.CALM).pathM());
        assertThat(told.edges()).hasSize(4);
        assertThat(told.edges().get(0).fromLonDeg())
                .as("the nearest first")
                .isCloseTo(at(10, 0).lonDeg(), within(1e-9));
    }

    @Test
    void whatIsFarFromTheBoatIsNotTold() {
        assertThat(avoiding(area(60, -2, 64, 2)).near(ORIGIN)).isEmpty();
    }

    @Test
    void edgesAreFoundAnewAsTheBoatComesNear() {
        NearbyEdges edges = avoiding(area(60, -2, 64, 2));

        assertThat(edges.near(at(20, 0))).isEmpty();
        assertThat(edges.near(at(40, 0))).isPresent();
        assertThat(edges.near(at(0, 0))).isEmpty();
    }

    @Test
    void ofALongEdgeOnlyWhatIsNearIsTold() {
        NoGoEdges told = avoiding(area(10, -5000, 5000, 5000)).near(ORIGIN).orElseThrow();

        assertThat(told.edges()).hasSize(1);
        assertThat(lengthM(told.edges().get(0))).isBetween(2 * 30.0 - 10, 2 * 36.0);
    }

    @Test
    void edgeOfTheAreaToStayInIsTold() {
        Water inside = Water.of(ORIGIN, List.of(), Optional.of(area(-100, -100, 10, 100)))
                .drivenWith(CrossTrackError.CALM);

        assertThat(new NearbyEdges(inside).near(ORIGIN).orElseThrow().edges()).hasSize(1);
    }

    /** Whichever way round its outline is told, and around a hole in it. */
    @Test
    void whatIsNotToBeEnteredLiesToStarboardOfItsEdges() {
        List<GeoPoint> outline = new ArrayList<>(area(10, -9, 30, 9).outline());
        List<GeoPoint> hole = area(14, -2, 18, 2).outline();

        assertThat(starboardSides(outline, hole)).hasSize(8).allMatch(isInside(outline, hole));
        Collections.reverse(outline);
        assertThat(starboardSides(outline, hole)).hasSize(8).allMatch(isInside(outline, hole));
    }

    private static Predicate<GeoPoint> isInside(List<GeoPoint> outline, List<GeoPoint> hole) {
        Water water = Water.of(ORIGIN, List.of(new GeoArea(outline, List.of(hole))), Optional.empty());
        return place -> water.depthM(place) > 0;
    }

    /** A place 0.5 m to starboard of the middle of each edge. */
    private static List<GeoPoint> starboardSides(List<GeoPoint> outline, List<GeoPoint> hole) {
        LocalPlane plane = new LocalPlane(ORIGIN);
        List<GeoPoint> places = new ArrayList<>();
        for (NoGoEdge edge : avoiding(new GeoArea(outline, List.of(hole)))
                .near(ORIGIN)
                .orElseThrow()
                .edges()) {
            Coordinate from = Areas.coordinate(GeoPoint.of(edge.fromLatDeg(), edge.fromLonDeg()), plane);
            Coordinate to = Areas.coordinate(GeoPoint.of(edge.toLatDeg(), edge.toLonDeg()), plane);
            double lengthM = from.distance(to);
            places.add(at(
                    (from.x + to.x) / 2 + 0.5 * (to.y - from.y) / lengthM,
                    (from.y + to.y) / 2 - 0.5 * (to.x - from.x) / lengthM));
        }
        return places;
    }

    @Test
    void ofMoreEdgesThanAMessageHoldsTheNearestAreTold() {
        List<GeoArea> posts = new ArrayList<>();
        for (int i = 0; i < 40; i++) {
            posts.add(area(-20 + i, 10, -19.5 + i, 10.5));
        }

        NoGoEdges told = avoiding(posts.toArray(GeoArea[]::new)).near(ORIGIN).orElseThrow();

        assertThat(told.edges()).hasSize(NoGoEdges.MOST_EDGES);
        assertThat(told.edges())
                .allSatisfy(edge -> assertThat(
                                Geodesy.distanceM(ORIGIN, GeoPoint.of(edge.fromLatDeg(), edge.fromLonDeg())))
                        .isLessThan(20));
    }
}
