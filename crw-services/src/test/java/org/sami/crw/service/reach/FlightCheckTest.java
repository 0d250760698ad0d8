package org.sami.crw.service.reach;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.sami.crw.service.Geodesy;
import org.sami.spn.value.GeoPoint;

class FlightCheckTest {
    private static final GeoPoint HOME = GeoPoint.of(45.7, 10.72);

    private static GeoPoint north(double metres, double altM) {
        GeoPoint point = Geodesy.offset(HOME, 0, metres);
        return new GeoPoint(point.latDeg(), point.lonDeg(), altM);
    }

    private static Flight flight(GeoPoint from, Optional<GeoPoint> home, GeoPoint... points) {
        return new Flight("copter1", from, List.of(points), 8, 0, home, Optional.empty());
    }

    private static Optional<String> doubt(Flight flight, Endurance endurance) {
        return FlightCheck.doubt(flight, endurance).map(WayDoubt::words);
    }

    @Test
    void flightIsTheClimbTheWayTheWayHomeAndTheDescent() {
        Flight flight = flight(HOME, Optional.of(HOME), north(800, 30));

        assertThat(flight.outS()).isBetween(111.0, 113.0); // 30 m up at 2.5 m/s, 800 m at 8 m/s
        assertThat(flight.homeS()).isBetween(119.0, 121.0); // 800 m at 8 m/s, 30 m down at 1.5 m/s
    }

    @Test
    void chargeThatDoesNotLastIsDoubtedWithItsNumbersAndWhatIsAssumed() {
        Flight flight = flight(HOME, Optional.of(HOME), north(800, 30));

        assertThat(doubt(flight, Endurance.usual(36))).isEmpty();
        assertThat(doubt(flight, Endurance.usual(35)))
                .contains("copter1 needs 232 s of flight, 120 s of them to come home and land, and its charge of 35 %"
                        + " lasts 225 s until 20 %, if a full battery lasts 25 minutes in the air, as nothing else"
                        + " was seen of it yet");
    }

    @Test
    void whatWasSeenOfTheAircraftCounts() {
        Flight flight = flight(HOME, Optional.of(HOME), north(800, 30));

        assertThat(doubt(flight, Endurance.seen(35, 0.05))).isEmpty();
        assertThat(doubt(flight, Endurance.seen(35, 0.1)))
                .contains("copter1 needs 232 s of flight, 120 s of them to come home and land, and its charge of 35 %"
                        + " lasts 150 s until 20 %");
    }

    @Test
    void hoveringCostsAsMuchAsFlying() {
        Flight stays = new Flight("copter1", north(0, 30), List.of(), 8, 60, Optional.of(HOME), Optional.empty());

        assertThat(stays.outS()).isEqualTo(60);
        assertThat(doubt(stays, Endurance.usual(25))).isPresent();
        assertThat(doubt(stays, Endurance.usual(26))).isEmpty();
    }

    @Test
    void oneThatIsToLandIsAlwaysToDoSo() {
        assertThat(doubt(flight(north(800, 30), Optional.of(HOME), HOME), Endurance.usual(5)))
                .isEmpty();
    }

    @Test
    void unknownHomeCountsAsALandingWhereItIsThen() {
        Flight flight = flight(north(0, 30), Optional.empty(), north(800, 30));

        assertThat(flight.homeS()).isEqualTo(20);
        assertThat(doubt(flight, Endurance.usual(21)).orElseThrow()).contains("20 s of them to land where it is then");
    }

    @Test
    void chargeBelowTheOneToLandWithLastsForNothing() {
        assertThat(Endurance.usual(12).seconds()).isZero();
    }
}
