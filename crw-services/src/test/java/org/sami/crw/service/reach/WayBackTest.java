package org.sami.crw.service.reach;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.sami.crw.service.Geodesy;
import org.sami.crw.service.water.CrossTrackError;
import org.sami.crw.service.water.Water;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPoint;

/** 1 % takes a boat 35 m. */
class WayBackTest {
    private static final GeoPoint HOME = GeoPoint.of(45.4, 10.9);

    private static GeoPoint at(double eastM, double northM) {
        return Geodesy.offset(HOME, eastM, northM);
    }

    private static Optional<WayBack> back(double percent, Optional<Water> water, GeoPoint... points) {
        return WayBack.of(
                new Way(
                        "anna",
                        Optional.of(HOME),
                        Optional.of(Charge.usual(percent)),
                        List.of(points),
                        List.of(),
                        water),
                HOME);
    }

    private static Optional<String> words(double percent, Optional<Water> water, GeoPoint... points) {
        return back(percent, water, points).map(WayBack::words);
    }

    @Test
    void whoBringsPlentyHomeIsNotSpokenOf() {
        assertThat(words(100, Optional.empty(), at(350, 0))).isEmpty();
    }

    @Test
    void littleThatIsBroughtHomeIsTold() {
        assertThat(words(32, Optional.empty(), at(350, 0)))
                .contains("anna comes home from its way with about 12 % of charge");
        assertThat(back(32, Optional.empty(), at(350, 0)).orElseThrow().isSure())
                .isTrue();
    }

    @Test
    void whoMayNotComeHomeIsNamedWithTheWays() {
        assertThat(words(15, Optional.empty(), at(350, 0)))
                .contains(
                        "anna may not come home from the end of its way: 350 m there and 350 m back, and its charge of"
                                + " 15 % is sure to last for 477 m");
        assertThat(back(15, Optional.empty(), at(350, 0)).orElseThrow().isSure())
                .isFalse();
    }

    @Test
    void wayAroundWhatIsToBeAvoidedCounts() {
        GeoArea wall = new GeoArea(List.of(at(100, -300), at(110, -300), at(110, 300), at(100, 300)), List.of());
        Water water = Water.of(HOME, List.of(wall), Optional.empty()).drivenWith(CrossTrackError.CALM);

        assertThat(words(52, Optional.of(water), at(350, 0)))
                .hasValueSatisfying(text -> assertThat(text).contains("comes home from its way with about 11 %"));
        assertThat(words(52, Optional.empty(), at(350, 0))).isEmpty();
    }

    @Test
    void wayThatTheChargeDoesNotLastForIsAskedAboutInstead() {
        assertThat(words(9, Optional.empty(), at(350, 0))).isEmpty();
    }

    /** Out 1 % takes it 10 m, and home 40 m: 100 m out cost 10 %, and home 2.5 %. */
    @Test
    void wayHomeCostsWhatItCostsAtTheSpeedOfWaysHome() {
        Charge charge = new Charge(32.4, 40).outward(10);
        Way way = new Way("anna", Optional.of(HOME), Optional.of(charge), List.of(at(100, 0)), List.of());

        assertThat(WayBack.of(way, HOME).map(WayBack::words))
                .contains("anna comes home from its way with about 20 % of charge");
    }
}
