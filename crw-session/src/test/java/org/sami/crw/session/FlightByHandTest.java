package org.sami.crw.session;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.sami.crw.handler.motion.WayLimits;
import org.sami.crw.service.reach.Endurance;
import org.sami.crw.service.water.CrossTrackError;
import org.sami.session.api.BoatStart;
import org.sami.spn.value.GeoPoint;

/** Where a copter flies, and a boat drives, that the operator sends somewhere: a point on the map has no altitude. */
class FlightByHandTest {
    private static final GeoPoint CLICKED = GeoPoint.of(45.701, 10.72);
    private static final GeoPoint HOME = GeoPoint.of(45.7, 10.72);

    private static HandWay.Start start(double altM, boolean flies, Optional<GeoPoint> home) {
        return new HandWay.Start(
                "kite",
                new BoatStart(new GeoPoint(45.7, 10.721, altM), CrossTrackError.NONE),
                Optional.empty(),
                home,
                flies,
                Optional.of(Endurance.seen(40, 0.1)).filter(known -> flies),
                8);
    }

    @Test
    void copterKeepsItsAltitudeAndTakesOffWhereItIsOnTheGround() {
        assertThat(start(35, true, Optional.empty()).to(CLICKED)).containsExactly(new GeoPoint(45.701, 10.72, 35));
        assertThat(start(0, true, Optional.empty()).to(CLICKED)).containsExactly(new GeoPoint(45.701, 10.72, 20));
        assertThat(start(0, false, Optional.empty()).to(CLICKED)).containsExactly(CLICKED);
    }

    private static List<String> doubts(HandWay.Start start, List<GeoPoint> to) {
        WayLimits none = new WayLimits(List.of(), Optional.empty());
        return HandWay.of(start, HandWay.command("by-hand", start, to, none), Optional.empty())
                .doubts();
    }

    @Test
    void flightForWhichTheChargeDoesNotLastIsDoubted() {
        HandWay.Start start = start(35, true, Optional.of(HOME));

        assertThat(doubts(start, start.to(CLICKED))).isEmpty();
        assertThat(doubts(start, start.to(GeoPoint.of(45.71, 10.72))))
                .singleElement()
                .asString()
                .matches("kite needs \\d+ s of flight, \\d+ s of them to come home and land, and its charge of 40 %"
                        + " lasts 200 s until 20 %");
        assertThat(doubts(start, start.back())).isEmpty();
    }

    @Test
    void copterReturnsThroughTheAirAndLandsAtItsHome() {
        assertThat(start(35, true, Optional.of(HOME)).back())
                .isEqualTo(List.of(new GeoPoint(45.7, 10.72, 35), new GeoPoint(45.7, 10.72, 0)));
    }

    @Test
    void returnIsRefusedOnTheGroundAndWithoutAHome() {
        assertThatThrownBy(() -> start(0, true, Optional.of(HOME)).back()).hasMessage("kite is on the ground");
        assertThatThrownBy(() -> start(35, true, Optional.empty()).back())
                .hasMessage("kite has not said where it took off");
    }
}
