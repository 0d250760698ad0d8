package org.sami.crw.proxy;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.sami.boat.link.NoGoEdge;
import org.sami.boat.link.NoGoEdges;
import org.sami.crw.service.Geodesy;
import org.sami.crw.service.water.CrossTrackError;
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

        assertThat(told.keepM()).isEqualTo(CrossTrackError.CALM.marginM());
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
