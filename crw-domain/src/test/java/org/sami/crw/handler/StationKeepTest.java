package org.sami.crw.handler;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.sami.crw.event.ProxyMaps;
import org.sami.crw.proxy.explanation.BoatExplanation;
import org.sami.crw.service.Geodesy;
import org.sami.spn.engine.MissionView;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.MissionStatus;
import org.sami.spn.protocol.Occurrence;
import org.sami.spn.protocol.Priority;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.RealValue;

/** A boat that is to stay where it is told, on a real boat server with a hull that something carries away. */
class StationKeepTest {
    private static final GeoPoint STATION = at(30, 0);
    private static final GeoPoint ELSEWHERE = at(0, 60);

    private final ScriptedEngine engine = new ScriptedEngine(TestWorld.VOCABULARY);
    private final TestWorld world = new TestWorld(engine);

    @BeforeEach
    void aBoatOnItsStation() {
        engine.missions.put(1L, new MissionView(1, 0, 1, "plan", "", MissionStatus.RUNNING, Map.of()));
        world.addBoat("a", 0, 0);
        world.run(1);
        happens(stationKeep());
        world.run(40);
    }

    @Test
    void theBoatGoesThereAndStays() {
        assertThat(distance(STATION)).isLessThan(6);
        BoatExplanation why = world.boats.find("a").orElseThrow().explain();
        assertThat(why.cause()).isEqualTo(BoatExplanation.Cause.KEEPS_STATION);
        assertThat(why.text()).contains("a keeps its station for mission 1");
        assertThat(engine.received("ProxyPathCompleted")).isEmpty();
    }

    @Test
    void aBoatThatIsCarriedAwayComesBackEachTime() {
        for (int i = 0; i < 3; i++) {
            world.hull("a").drift(15, 15);
            assertThat(distance(STATION)).isGreaterThan(12);
            world.run(40);
            assertThat(distance(STATION)).isLessThan(6);
        }
    }

    @Test
    void aBoatInsideTheRadiusIsLeftAlone() {
        world.run(20);
        GeoPoint lies = world.hull("a").position();
        world.run(20);

        assertThat(Geodesy.distanceM(lies, world.hull("a").position())).isLessThan(1);
        assertThat(world.hull("a").isAtRest()).isTrue();
    }

    @Test
    void whatInterruptsItGoesFirstAndThenTheBoatReturns() {
        happens(goElsewhere(8, 5).priority(Priority.CRITICAL));
        world.run(60);
        assertThat(engine.received("ProxyPathCompleted")).hasSize(1);
        world.run(60);

        assertThat(distance(STATION)).isLessThan(6);
    }

    @Test
    void otherMissionsWaitUntilThisOneEnds() {
        happens(goElsewhere(8, 5));
        world.run(60);
        assertThat(distance(STATION)).isLessThan(6);

        world.happens(engine, new Effect.CommandsWithdrawn(1, List.of()));
        world.run(60);

        assertThat(distance(ELSEWHERE)).isLessThan(6);
    }

    @Test
    void anotherWishOfTheSameMissionTakesItsPlace() {
        happens(goElsewhere(8, 1));
        world.run(120);

        assertThat(distance(ELSEWHERE)).isLessThan(6);
        assertThat(engine.received("ProxyPathCompleted"))
                .extracting(Occurrence::activation)
                .containsExactly(8L);
    }

    @Test
    void afterALostLinkTheStationIsKeptOn() {
        world.cutLinks(true);
        world.run(10);
        world.hull("a").drift(0, 30);
        world.run(1);
        world.cutLinks(false);
        world.run(60);

        assertThat(distance(STATION)).isLessThan(6);
        assertThat(engine.received("ProxyPathFailed")).isEmpty();
    }

    @Test
    void aBoatWithoutAStationIsAFailureOfTheRequest() {
        happens(new TestActivations("ProxyStationKeep")
                .id(9)
                .with("points", ProxyMaps.toValue(Map.of()))
                .with("radius", new RealValue(10))
                .of("a"));

        assertThat(engine.inputs)
                .filteredOn(Input.HandlerFailed.class::isInstance)
                .singleElement()
                .satisfies(failed ->
                        assertThat(((Input.HandlerFailed) failed).reason()).contains("no station for a"));
    }

    private static TestActivations stationKeep() {
        return new TestActivations("ProxyStationKeep")
                .with("points", ProxyMaps.toValue(Map.of("a", STATION)))
                .with("radius", new RealValue(10))
                .of("a");
    }

    private static TestActivations goElsewhere(long id, long mission) {
        return new TestActivations("ProxyGotoLatLon")
                .id(id)
                .mission(mission)
                .with("location", ELSEWHERE)
                .of("a");
    }

    private void happens(TestActivations asking) {
        world.happens(engine, asking.effect());
    }

    private double distance(GeoPoint point) {
        return Geodesy.distanceM(world.hull("a").position(), point);
    }

    private static GeoPoint at(double eastM, double northM) {
        return Geodesy.offset(TestWorld.HOME, eastM, northM);
    }
}
