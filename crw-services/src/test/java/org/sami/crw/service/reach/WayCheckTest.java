package org.sami.crw.service.reach;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.sami.crw.service.Geodesy;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPoint;

/** What is wrong with a way is found before a boat is sent along it. */
class WayCheckTest {
    private static final GeoPoint HERE = GeoPoint.of(45.7, 10.72);

    private static Optional<WayDoubt> doubt(double percent, List<GeoArea> avoid, GeoPoint... points) {
        return WayCheck.doubt(
                new Way("anna", Optional.of(HERE), Optional.of(Charge.usual(percent)), List.of(points), avoid));
    }

    private static GeoPoint at(double eastM, double northM) {
        return Geodesy.offset(HERE, eastM, northM);
    }

    @Test
    void ordinaryWayIsNotDoubted() {
        assertThat(doubt(100, List.of(), at(600, 0), at(600, 600), at(0, 0))).isEmpty();
    }

    @Test
    void placeFarAwayIsDoubted() {
        assertThat(doubt(100, List.of(), at(300, 0), at(48_000, 0)))
                .contains(new WayDoubt(
                        WayDoubt.Kind.PLACE, "anna is to go 48 km from where it is, to 45.69834,11.33631"));
    }

    @Test
    void exchangedLatitudeAndLongitudeAreNamed() {
        WayDoubt doubt = doubt(100, List.of(), GeoPoint.of(10.721, 45.701)).orElseThrow();

        assertThat(doubt.kind()).isEqualTo(WayDoubt.Kind.PLACE);
        assertThat(doubt.words()).endsWith("; are latitude and longitude exchanged? 45.70100,10.72100 is near");
    }

    @Test
    void pointOnLandIsDoubted() {
        GeoArea island = new GeoArea(List.of(at(200, -50), at(300, -50), at(300, 50), at(200, 50)), List.of());

        assertThat(doubt(100, List.of(island), at(400, 0))).as("beyond it").isEmpty();
        assertThat(doubt(100, List.of(island), at(100, 0), at(250, 0)))
                .hasValueSatisfying(doubt -> assertThat(doubt.words())
                        .startsWith("anna is to go to ")
                        .endsWith("point 2 of its way, which lies 50.0 m inside a no-go area"));
    }

    @Test
    void whoIsInsideMayClimbThereAndLeave() {
        GeoArea around = new GeoArea(List.of(at(-50, -50), at(50, -50), at(50, 50), at(-50, 50)), List.of());
        GeoPoint up = new GeoPoint(HERE.latDeg(), HERE.lonDeg(), 15);

        assertThat(doubt(100, List.of(around), up, at(200, 0))).isEmpty();
        assertThat(doubt(100, List.of(around), up, at(20, 0), at(200, 0)))
                .hasValueSatisfying(doubt -> assertThat(doubt.words()).contains("point 2 of its way"));
        assertThat(doubt(100, List.of(around), up)).as("it stays there").isPresent();
    }

    @Test
    void wayThatIsLongerThanTheChargeLastsIsDoubted() {
        assertThat(doubt(20, List.of(), at(630, 0))).isEmpty();
        assertThat(doubt(20, List.of(), at(330, 0), at(0, 0))) // 700 m on the average
                .contains(new WayDoubt(
                        WayDoubt.Kind.CHARGE,
                        "anna is to go 660 m, and its charge of 20 % is sure to last for 636 m, 24 m less"));
    }

    @Test
    void boatThatSaysAShorterRangeIsDoubtedForAShorterWay() {
        Way way = new Way("anna", Optional.of(HERE), Optional.of(new Charge(20, 15)), List.of(at(300, 0)), List.of());

        assertThat(WayCheck.doubt(way))
                .contains(new WayDoubt(
                        WayDoubt.Kind.CHARGE,
                        "anna is to go 300 m, and its charge of 20 % is sure to last for 273 m, 27 m less"));
        assertThat(doubt(20, List.of(), at(300, 0))).isEmpty();
    }

    @Test
    void nothingIsSaidOfABoatWhosePositionIsNotKnown() {
        assertThat(WayCheck.doubt(new Way(
                        "anna", Optional.empty(), Optional.of(Charge.usual(1)), List.of(at(48_000, 0)), List.of())))
                .isEmpty();
    }
}
