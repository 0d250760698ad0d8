package org.sami.crw.handler;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import org.sami.boat.link.BoatPerformance;
import org.sami.crw.event.Allocation;
import org.sami.crw.handler.activation.EventNames;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.Occurrence;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.ListValue;
import org.sami.spn.value.RealValue;
import org.sami.spn.value.TaskId;
import org.sami.spn.value.TextValue;
import org.sami.spn.value.Value;
import org.sami.spn.vocabulary.Direction;

/** Requests for allocations, and what their answers are made of. */
class AllocationRequestTest extends TwoBoatsOnHandlers {
    @Test
    void everyAnswerIsAnInputEventOfTheVocabulary() throws IllegalAccessException {
        int seen = 0;
        for (java.lang.reflect.Field name : EventNames.class.getDeclaredFields()) {
            if (name.getType() == String.class) {
                assertThat(TestWorld.VOCABULARY.event((String) name.get(null)))
                        .as(name.getName())
                        .hasValueSatisfying(type -> assertThat(type.direction()).isEqualTo(Direction.INPUT));
                seen++;
            }
        }
        assertThat(seen).isGreaterThan(10);
    }

    @Test
    void locationsAreDividedAmongTheEnteringBoats() {
        GeoPoint left = at(-120, 20);
        GeoPoint right = at(130, 20);

        world.happens(
                engine,
                new TestActivations("AllocationRequest")
                        .with("locations", new ListValue(List.of(right, left)))
                        .of("west", "east")
                        .effect());

        Occurrence answer = only("AllocationResponse");
        assertThat(answer.proxies()).containsExactly("west", "east");
        Value option = ((ListValue) answer.values().get("allocations")).items().get(0);
        Allocation allocation = Allocation.of(option);
        assertThat(allocation.paths().get("west").points()).containsExactly(left);
        assertThat(allocation.paths().get("east").points()).containsExactly(right);
        assertFitsVocabulary(answer);
    }

    @Test
    void aLocationBehindWhatIsAvoidedGoesToTheBoatWithTheShorterWayAndOneInALagoonToNobody() {
        GeoArea wall = area(-30, -400, -20, 400);
        GeoArea lagoon = new GeoArea(
                area(300, 300, 400, 400).outline(),
                List.of(area(310, 310, 390, 390).outline()));
        GeoPoint behind = at(-10, 0);

        world.happens(
                engine,
                new TestActivations("AllocationRequest")
                        .with("locations", new ListValue(List.of(behind, at(350, 350))))
                        .with("avoid", new ListValue(List.of(wall, lagoon)))
                        .of("west", "east")
                        .effect());

        Value option = ((ListValue) only("AllocationResponse").values().get("allocations"))
                .items()
                .get(0);
        Allocation allocation = Allocation.of(option);
        assertThat(allocation.paths().get("west").points()).isEmpty();
        assertThat(allocation.paths().get("east").points()).containsExactly(behind);
        assertThat(allocation.longestM()).isBetween(109.9, 110.1);
        assertThat(messages()).anyMatch(text -> text.startsWith("location 2, at ") && text.contains("no boat"));
    }

    /** 1 % takes the boat 2 m: its charge lasts for 181 m, and for the way home as well for half of that. */
    @Test
    void boatThatSaysAShortRangeGetsWhatItsChargeLastsFor() {
        world.addBoat(
                "short",
                0,
                50,
                hull -> hull.performance =
                        new BoatPerformance(OptionalDouble.of(2), OptionalDouble.empty(), OptionalDouble.empty()));
        world.run(1);

        Allocation allocation = allocated(List.of(at(0, 60), at(0, 160), at(0, 260)), "west", "short");

        assertThat(allocation.paths().get("short").points()).containsExactly(at(0, 60));
        assertThat(allocation.paths().get("west").points()).hasSize(2);
    }

    @Test
    void fasterBoatGetsMore() {
        world.addBoat(
                "fast",
                0,
                50,
                hull -> hull.performance =
                        new BoatPerformance(OptionalDouble.empty(), OptionalDouble.of(3), OptionalDouble.empty()));
        world.addBoat(
                "slow",
                0,
                50,
                hull -> hull.performance =
                        new BoatPerformance(OptionalDouble.empty(), OptionalDouble.of(0.5), OptionalDouble.empty()));
        world.run(1);

        Allocation allocation = allocated(List.of(at(30, 50), at(-30, 50), at(60, 50)), "slow", "fast");

        assertThat(allocation.paths().get("slow").points()).isEmpty();
        assertThat(allocation.paths().get("fast").points()).hasSize(3);
    }

    /** Both lie in the midst of four locations: whoever has two turns sharply between them. */
    @Test
    void boatWithAWideTurningCircleGetsLess() {
        world.addBoat("wide", 0, 50, hull -> hull.performance = turningIn(30));
        world.addBoat("narrow", 0, 50, hull -> hull.performance = turningIn(0));
        world.run(1);

        Allocation allocation = allocated(List.of(at(0, 70), at(0, 30), at(20, 50), at(-20, 50)), "wide", "narrow");

        assertThat(allocation.paths().get("wide").points()).containsExactly(at(0, 70));
        assertThat(allocation.paths().get("narrow").points()).hasSize(3);
    }

    private static BoatPerformance turningIn(double radiusM) {
        return new BoatPerformance(OptionalDouble.empty(), OptionalDouble.empty(), OptionalDouble.of(radiusM));
    }

    private Allocation allocated(List<GeoPoint> locations, String... boats) {
        world.happens(
                engine,
                new TestActivations("AllocationRequest")
                        .with("locations", new ListValue(List.copyOf(locations)))
                        .of(boats)
                        .effect());
        Value option = ((ListValue) only("AllocationResponse").values().get("allocations"))
                .items()
                .get(0);
        return Allocation.of(option);
    }

    private static GeoArea area(double west, double south, double east, double north) {
        return new GeoArea(List.of(at(west, south), at(east, south), at(east, north), at(west, north)), List.of());
    }

    @Test
    void tasksBringTheirOwnLocations() {
        engine.tasks.put(new TaskId(1, "t1"), Map.of("location", at(50, 50)));

        world.happens(
                engine,
                new TestActivations("AllocationRequest")
                        .task("t1", "east", "depth", new RealValue(1))
                        .effect());

        Occurrence answer = only("AllocationResponse");
        assertThat(answer.tasks()).containsExactly(new TaskId(1, "t1"));
        Value option = ((ListValue) answer.values().get("allocations")).items().get(0);
        assertThat(Allocation.of(option).paths().get("east").points()).containsExactly(at(50, 50));
    }

    /** It says so itself: no plan has to say it. */
    @Test
    void taskThatNeedsACameraGoesToTheBoatThatHasOne() {
        world.addBoat("seeing", 100, 60, TestHull::photographs);
        world.run(1);
        Value camera = new ListValue(List.of(new TextValue("camera")));
        engine.tasks.put(new TaskId(1, "picture"), Map.of("location", at(-100, 0), "needs", camera));

        world.happens(
                engine,
                new TestActivations("AllocationRequest")
                        .task("picture", "", "location", at(-100, 0))
                        .of("west", "seeing")
                        .effect());

        Value option = ((ListValue) only("AllocationResponse").values().get("allocations"))
                .items()
                .get(0);
        assertThat(Allocation.of(option).paths().get("seeing").points()).containsExactly(at(-100, 0));
        assertThat(Allocation.of(option).paths().get("west").points()).isEmpty();
    }

    @Test
    void aBoatThatWasNeverHeardOfGetsNothingAndTheOperatorIsTold() {
        world.happens(
                engine,
                new TestActivations("AllocationRequest")
                        .with("locations", new ListValue(List.of(at(0, 0))))
                        .of("ghost", "east")
                        .effect());

        Value option = ((ListValue) only("AllocationResponse").values().get("allocations"))
                .items()
                .get(0);
        assertThat(Allocation.of(option).paths()).containsOnlyKeys("east");
        assertThat(messages()).anyMatch(text -> text.contains("ghost"));
    }

    @Test
    void aRequestThatCannotBeMetFailsWithItsReason() {
        world.happens(
                engine, new TestActivations("AllocationRequest").of("east").effect());
        world.happens(engine, new TestActivations("AllocationRequest").effect());
        world.happens(
                engine,
                new TestActivations("AllocationRequest")
                        .with("locations", new ListValue(List.of(at(0, 0))))
                        .of("ghost")
                        .effect());

        assertThat(engine.inputs.stream()
                        .filter(Input.HandlerFailed.class::isInstance)
                        .map(input -> ((Input.HandlerFailed) input).reason()))
                .satisfiesExactly(
                        reason -> assertThat(reason).contains("locations"),
                        reason -> assertThat(reason).contains("No boat entered"),
                        reason -> assertThat(reason).contains("ghost"));
    }
}
