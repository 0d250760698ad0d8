package org.sami.crw.handler;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.Set;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.sami.boat.link.BoatPerformance;
import org.sami.boat.link.PowerCurve;
import org.sami.crw.event.ProxyMaps;
import org.sami.crw.message.OperatorMessage;
import org.sami.crw.service.Geodesy;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.Occurrence;
import org.sami.spn.protocol.Outcome;
import org.sami.spn.value.EnumValue;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPath;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.ListValue;
import org.sami.spn.value.RealValue;
import org.sami.spn.value.Value;

/** What a mission and its boats make of an area to explore. */
class ExploreAreaTest {
    private final ScriptedEngine engine = new ScriptedEngine(TestWorld.VOCABULARY);
    private final TestWorld world = new TestWorld(engine);

    @BeforeEach
    void twoBoats() {
        world.addBoat("west", -60, 0);
        world.addBoat("east", 60, 0);
        world.run(1);
    }

    @Test
    void bothBoatsExploreTheirHalvesAtTheSameTime() {
        world.happens(engine, asking(7).of("west", "east").effect());
        world.run(20);
        double west = Geodesy.distanceM(world.hull("west").position(), at(-60, 0));
        double east = Geodesy.distanceM(world.hull("east").position(), at(60, 0));
        runUntilCompleted(2);

        assertThat(west).isGreaterThan(15);
        assertThat(east).isGreaterThan(15);
        assertThat(engine.received("ProxyPathCompleted"))
                .extracting(Occurrence::proxies)
                .containsExactlyInAnyOrder(List.of("west"), List.of("east"));
        assertThat(shares().keySet()).containsExactlyInAnyOrder("west", "east");
        assertThat(messages()).anyMatch(text -> text.startsWith("Exploring 1600 m² in ") && text.contains("uncovered"));
    }

    @Test
    void operatorIsToldOnceWhatWasCoveredWhenTheLastShareIsDriven() {
        world.happens(engine, asking(7).of("west", "east").effect());
        runUntilCompleted(1);
        List<String> before = messages();
        runUntilCompleted(2);
        world.happens(engine, new Effect.MissionEnded(1, Outcome.COMPLETED));
        world.run(1);

        assertThat(before).noneMatch(text -> text.startsWith("Explored"));
        assertThat(messages())
                .filteredOn(text -> text.startsWith("Explored"))
                .singleElement()
                .satisfies(text -> assertThat(text)
                        .matches("Explored (9[5-9]\\.\\d\\d|100\\.00) % of 1600 m² by the positions that boats"
                                + " reported \\(planned (99\\.\\d\\d|100\\.00) %\\)(; \\d+ m² are left,"
                                + " most near [0-9.,]+)?"));
    }

    @Test
    void operatorIsToldWhatWasCoveredWhenTheMissionEndsBeforeThat() {
        world.happens(engine, asking(7).of("west", "east").effect());
        world.run(80);

        world.happens(engine, new Effect.MissionEnded(1, Outcome.ABORTED));
        world.run(300);

        assertThat(messages())
                .filteredOn(text -> text.startsWith("Explored"))
                .singleElement()
                .satisfies(text -> {
                    assertThat(text)
                            .contains(" % of 1600 m² by the positions that boats reported until the mission ended"
                                    + " (planned ");
                    assertThat(percentIn(text)).isBetween(10.0, 80.0);
                });
    }

    /** Nobody saw where boats drove for an earlier base. */
    @Test
    void forABaseThatGoesOnWhatWasVisitedBeforeCountsAsPlanned() {
        world.happens(engine, asking(7).of("west", "east").effect());
        world.run(60);
        TestWorld next = new TestWorld(engine);
        next.addBoat("west", -20, 0);
        next.addBoat("east", 20, 0);
        next.run(1);

        next.happens(engine, asking(7).of("west", "east").effect());
        next.run(400);

        assertThat(next.operator.messages().messages())
                .extracting(OperatorMessage::text)
                .filteredOn(text -> text.startsWith("Explored"))
                .singleElement()
                .satisfies(text -> {
                    assertThat(text).endsWith("; what was driven before this base began counts as planned");
                    assertThat(percentIn(text)).isGreaterThan(85);
                });
    }

    private static double percentIn(String text) {
        return Double.parseDouble(text.substring("Explored ".length(), text.indexOf(" %")));
    }

    /** As after an interrupt: the boat was away, and its place asks again. */
    @Test
    void aBoatThatComesBackGoesOnWhereItWas() {
        world.happens(engine, asking(7).of("west", "east").effect());
        world.run(60);
        Map<String, GeoPath> before = shares();
        GeoPoint first = before.get("west").points().get(0);
        double fromFirstM = Geodesy.distanceM(world.hull("west").position(), first);

        world.happens(engine, asking(9).of("west").effect());
        double nearestM = Double.POSITIVE_INFINITY;
        for (int second = 0;
                second < 600 && engine.received("ProxyPathCompleted").size() < 2;
                second++) {
            world.run(1);
            nearestM = Math.min(nearestM, Geodesy.distanceM(world.hull("west").position(), first));
        }

        assertThat(shares()).isEqualTo(before);
        assertThat(fromFirstM).isGreaterThan(8);
        assertThat(nearestM).isGreaterThan(4);
        assertThat(engine.received("ProxyPathCompleted")).hasSize(2);
    }

    @Test
    void aBoatThatComesLaterTakesOverWhatALostOneHasLeft() {
        world.addBoat("third", 0, -60);
        world.run(1);
        world.happens(engine, asking(7).of("west", "east").effect());
        world.run(90);
        int whole = shares().get("east").points().size();

        world.happens(engine, asking(9).of("west", "third").effect());

        assertThat(shares().keySet()).isSubsetOf(Set.of("west", "east", "third"));
        assertThat(shares().get("third").points().size()).isBetween(1, whole - 1);
        assertThat(messages()).anyMatch(text -> text.startsWith("third explores what east has left: "));
    }

    @Test
    void aBoatWithoutAWayFailsAndTheOtherExploresAll() {
        List<GeoPoint> outer = box(-70, -10, -50, 10).outline();
        GeoArea wall = new GeoArea(outer, List.of(box(-65, -5, -55, 5).outline()));

        world.happens(
                engine,
                asking(7)
                        .with("avoid", new ListValue(List.of(wall)))
                        .of("west", "east")
                        .effect());
        runUntilCompleted(1);

        assertThat(engine.received("ProxyPathFailed")).singleElement().satisfies(failed -> {
            assertThat(failed.proxies()).containsExactly("west");
            assertThat(failed.values().get("reason").toString()).contains("all the way between");
        });
        assertThat(engine.received("ProxyPathCompleted"))
                .extracting(Occurrence::proxies)
                .containsExactly(List.of("east"));
        assertThat(messages()).anyMatch(text -> text.startsWith("west could not do what \"here\" asked"));
    }

    @Test
    void forExecutionTimeBoatsDriveAtTwiceTheSpeed() {
        world.happens(engine, moving("usual").effect());
        world.run(15);
        double usual = world.hull("west").speedMps();

        world.happens(
                engine,
                moving("fast")
                        .id(8)
                        .mission(2)
                        .markup("Optimize", "criteria", new EnumValue("Criterion", "EXECUTION_TIME"))
                        .effect());
        world.run(15);
        double fast = world.hull("east").speedMps();

        assertThat(usual).isCloseTo(1.5, within(0.1));
        assertThat(fast).isCloseTo(2 * usual, within(0.1));
        assertThat(messages()).containsExactly("here: boats drive at twice the cruise speed, for execution time");
    }

    @Test
    void forExecutionEfficiencyABoatThatKnowsWhatItUsesDrivesAtTheSpeedThatCostsLeast() {
        world.addBoat("known", 0, 20, hull -> hull.performance = BoatPerformance.UNKNOWN.with(dragOf(35)));
        world.run(1);

        for (String boat : List.of("known", "east")) {
            world.happens(
                    engine,
                    new TestActivations("ProxyGotoLatLon")
                            .id(boat.length())
                            .with("location", at(60, 500))
                            .markup("Optimize", "criteria", new EnumValue("Criterion", "EXECUTION_EFFICIENCY"))
                            .of(boat)
                            .effect());
        }
        world.run(15);

        assertThat(world.hull("known").speedMps()).isCloseTo(0.75, within(0.1));
        assertThat(world.hull("east").speedMps()).isCloseTo(1.5, within(0.1));
    }

    @Test
    void boatWithAWideTurningCircleHasTheShorterShare() {
        world.addBoat("wide", -60, 20, hull -> hull.performance = turningIn(20));
        world.addBoat("narrow", 60, 20, hull -> hull.performance = turningIn(0));
        world.run(1);

        world.happens(engine, asking(7).of("wide", "narrow").effect());
        world.run(1);

        Map<String, GeoPath> shares = shares();
        double wideM = trackM(shares.get("wide"));
        double narrowM = trackM(shares.get("narrow"));
        assertThat(wideM).isBetween(0.3 * narrowM, 0.85 * narrowM);
    }

    private static double trackM(GeoPath share) {
        return Geodesy.lengthM(share.points().get(0), share.points());
    }

    private static BoatPerformance turningIn(double radiusM) {
        return new BoatPerformance(OptionalDouble.empty(), OptionalDouble.empty(), OptionalDouble.of(radiusM));
    }

    /** A full battery takes such a boat 200 m at the cruise speed, and 50 m at twice of it. */
    @Test
    void chargesAreCountedAtTheSpeedThatOptimizeAsksFor() {
        for (String boat : List.of("a", "b")) {
            world.addBoat(boat, 0, 0, hull -> hull.performance = BoatPerformance.UNKNOWN.with(dragOf(2)));
        }
        world.run(1);

        world.happens(engine, asking(7).of("a", "b").effect());
        world.run(5);
        boolean isAskedAtCruiseSpeed = isAsked();
        world.happens(
                engine,
                asking(8)
                        .mission(2)
                        .markup("Optimize", "criteria", new EnumValue("Criterion", "EXECUTION_TIME"))
                        .of("a", "b")
                        .effect());
        world.run(5);

        assertThat(isAskedAtCruiseSpeed).isFalse();
        assertThat(isAsked()).isTrue();
    }

    private boolean isAsked() {
        return engine.inputs.stream()
                .anyMatch(input -> input instanceof Input.AskOperator asked
                        && asked.prompt().startsWith("charges are sure to last for "));
    }

    private static PowerCurve dragOf(double metresPerPercent) {
        return PowerCurve.drag(metresPerPercent, 1.5, 0);
    }

    private static TestActivations moving(String how) {
        boolean usual = how.equals("usual");
        return new TestActivations("ProxyGotoLatLon")
                .with("location", usual ? at(-60, 500) : at(60, 500))
                .of(usual ? "west" : "east");
    }

    private static TestActivations asking(long id) {
        return new TestActivations("ProxyExploreArea")
                .id(id)
                .with("area", box(-20, -20, 20, 20))
                .with("spacing", new RealValue(10));
    }

    private Map<String, GeoPath> shares() {
        List<Value> remembered = engine.inputs.stream()
                .filter(input -> input instanceof Input.Remember remember
                        && remember.key().startsWith("explore/"))
                .map(input -> ((Input.Remember) input).value())
                .toList();
        return ProxyMaps.read(remembered.get(remembered.size() - 1), GeoPath.class);
    }

    private void runUntilCompleted(int boats) {
        for (int second = 0;
                second < 600 && engine.received("ProxyPathCompleted").size() < boats;
                second++) {
            world.run(1);
        }
    }

    private List<String> messages() {
        return world.operator.messages().messages().stream()
                .map(OperatorMessage::text)
                .toList();
    }

    private static GeoArea box(double west, double south, double east, double north) {
        return new GeoArea(List.of(at(west, south), at(east, south), at(east, north), at(west, north)), List.of());
    }

    private static GeoPoint at(double eastM, double northM) {
        return Geodesy.offset(TestWorld.HOME, eastM, northM);
    }
}
