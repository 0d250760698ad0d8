package org.sami.crw.handler;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.sami.boat.link.TrackingError;
import org.sami.crw.event.ProxyMaps;
import org.sami.crw.service.Geodesy;
import org.sami.spn.engine.MissionView;
import org.sami.spn.protocol.MissionStatus;
import org.sami.spn.protocol.Occurrence;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.ListValue;
import org.sami.spn.value.RealValue;

/** Requests for places of assembly, and the messages about boats that would lie too near to each other. */
class AssemblyRequestTest extends TwoBoatsOnHandlers {
    @Test
    void boatsAssembleApartAlsoWhenTheyComeOneByOne() {
        for (String boat : List.of("west", "east")) {
            world.happens(
                    engine,
                    new TestActivations("AssembleLocationRequest")
                            .with("location", TestWorld.HOME)
                            .with("spacing", new RealValue(10))
                            .of(boat)
                            .effect());
        }

        List<Occurrence> answers = engine.received("AssembleLocationResponse");
        GeoPoint first = point(answers.get(0), "west");
        GeoPoint second = point(answers.get(1), "east");
        assertThat(first).isEqualTo(TestWorld.HOME);
        assertThat(Geodesy.distanceM(first, second)).isGreaterThan(9.99);
        assertThat(point(answers.get(1), "west")).isEqualTo(first);
        assertFitsVocabulary(answers.get(1));
    }

    @Test
    void ofPlacesThatLeaveNoWayBetweenBoatsWhosePositionsErrTheOperatorIsToldOnce() {
        addErringBoats();

        assemble(10, "erring");
        assertThat(messages()).as("one boat is in nobody's way").noneMatch(text -> text.contains("apart"));
        assemble(10, "other");
        assemble(10, "erring", "other");

        assertThat(messages().stream().filter(text -> text.contains("apart")))
                .containsExactly(
                        "Assembly: boats that lie 10 m apart leave others no way between them, which wait near by;"
                                + " 17 m are enough for boats whose positions err by 1.6 m");
    }

    @Test
    void placesThatLeaveWaysBetweenThemNeedNoMessage() {
        assemble(10, "west", "east");

        assertThat(messages()).noneMatch(text -> text.contains("apart"));
    }

    @Test
    void ofPointsGivenStraightToStationKeepingThatAreTooNearTheOperatorIsToldOnce() {
        addErringBoats();

        keep(at(0, 0), at(8, 0));
        keep(at(0, 0), at(9, 0));

        assertThat(messages().stream().filter(text -> text.contains("apart")))
                .singleElement()
                .asString()
                .startsWith("Station keeping: boats that lie 8 m apart")
                .contains("17 m are enough");
    }

    @Test
    void stationsOfWhichTheAssemblyWasToldAreNotToldAgain() {
        addErringBoats();

        assemble(10, "erring", "other");
        keep(at(0, 0), at(10, 0));

        assertThat(messages().stream().filter(text -> text.contains("apart")))
                .singleElement()
                .asString()
                .startsWith("Assembly");
    }

    @Test
    void stationsThatLeaveWaysBetweenThemNeedNoMessage() {
        addErringBoats();

        keep(at(0, 0), at(20, 0));

        assertThat(messages()).noneMatch(text -> text.contains("apart"));
    }

    @Test
    void ofListsOfLocationsThatEndTooNearToOneAnotherTheOperatorIsTold() {
        List<GeoPoint> locations = List.of(at(-100, 20), at(-3, 0), at(100, 20), at(3, 0));

        world.happens(
                engine,
                new TestActivations("DistributeLocationsRequest")
                        .with("locations", new ListValue(List.copyOf(locations)))
                        .of("west", "east")
                        .effect());

        assertThat(messages().stream().filter(text -> text.contains("apart")))
                .singleElement()
                .asString()
                .startsWith("Distribution: boats that lie 6 m apart");
    }

    private void addErringBoats() {
        world.addBoat("erring", 0, 50, hull -> hull.error = Optional.of(new TrackingError(1.6, 0.2)));
        world.addBoat("other", 0, 60, hull -> hull.error = Optional.of(new TrackingError(1.6, 0.2)));
        world.run(1);
        engine.missions.put(1L, new MissionView(1, 0, 1, "plan", "", MissionStatus.RUNNING, Map.of()));
    }

    private void keep(GeoPoint erring, GeoPoint other) {
        world.happens(
                engine,
                new TestActivations("ProxyStationKeep")
                        .with("points", ProxyMaps.toValue(Map.of("erring", erring, "other", other)))
                        .with("radius", new RealValue(5))
                        .of("erring", "other")
                        .effect());
    }

    private void assemble(double spacingM, String... boats) {
        world.happens(
                engine,
                new TestActivations("AssembleLocationRequest")
                        .with("location", TestWorld.HOME)
                        .with("spacing", new RealValue(spacingM))
                        .of(boats)
                        .effect());
    }
}
