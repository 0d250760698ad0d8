package org.sami.crw.handler;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.sami.boat.link.BoatPerformance;
import org.sami.boat.link.TrackingError;
import org.sami.crw.event.PathOption;
import org.sami.crw.event.ProxyMaps;
import org.sami.crw.message.OperatorMessage;
import org.sami.crw.service.Geodesy;
import org.sami.crw.service.water.Water;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.Occurrence;
import org.sami.spn.protocol.Priority;
import org.sami.spn.value.EnumValue;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPath;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.IntegerValue;
import org.sami.spn.value.ListValue;
import org.sami.spn.value.RealValue;
import org.sami.spn.value.RecordValue;
import org.sami.spn.value.TextValue;
import org.sami.spn.value.Value;
import org.sami.spn.vocabulary.Vocabulary;

/** What a plan and the operator get for a request of paths. */
class PathRequestTest {
    private static final GeoArea ISLAND = box(-20, -40, 20, 60);

    private final ScriptedEngine engine = new ScriptedEngine(TestWorld.VOCABULARY);
    private final TestWorld world = new TestWorld(engine);

    @BeforeEach
    void twoBoats() {
        world.addBoat("west", -100, 0);
        world.addBoat("east", 100, 0);
        world.run(1);
    }

    @Test
    void eachBoatGetsAWayAroundWhatIsToBeAvoided() {
        world.happens(
                engine,
                asking().with("avoid", new ListValue(List.of(ISLAND)))
                        .of("west", "east")
                        .effect());

        Occurrence answer = answer();
        Map<String, GeoPath> paths = paths(answer, 0);
        assertThat(answer.proxies()).containsExactly("west", "east");
        assertThat(answer.values()).containsEntry("noWay", ProxyMaps.toValue(Map.of()));
        assertThat(options(answer)).hasSize(1);
        assertThat(last(paths, "west")).isEqualTo(at(80, 0));
        assertThat(last(paths, "east")).isEqualTo(at(150, 10));
        assertThat(paths.get("west").points()).hasSize(3);
        assertThat(paths.get("east").points()).hasSize(1);
        assertClear(paths, 0.05);
    }

    /** Where it says nothing, what is stated counts: here still water. */
    @Test
    void boatThatSaysHowFarItMayBeBesideItsWayIsKeptAsFarOff() {
        Map<String, GeoPoint> points = Map.of("west", at(80, 0), "far", at(80, 10));
        world.addBoat("far", -100, 10, hull -> hull.error = Optional.of(new TrackingError(2, 0.5)));
        world.run(1);

        world.happens(
                engine,
                asking().with("points", ProxyMaps.toValue(points))
                        .with("avoid", new ListValue(List.of(ISLAND)))
                        .of("west", "far")
                        .effect());

        Map<String, GeoPath> paths = paths(answer(), 0);
        assertThat(clearanceM(paths, "west", at(-100, 0))).isBetween(0.6, 1.0);
        assertThat(clearanceM(paths, "far", at(-100, 10))).isBetween(8.6, 9.0); // 0.6 + 3 * 2 + 4 * 0.5
    }

    @Test
    void boatWithATurningCircleIsKeptOffByItsRadius() {
        Map<String, GeoPoint> points = Map.of("west", at(80, 0), "wide", at(80, 10));
        world.addBoat(
                "wide",
                -100,
                10,
                hull -> hull.performance =
                        new BoatPerformance(OptionalDouble.empty(), OptionalDouble.empty(), OptionalDouble.of(5)));
        world.run(1);

        world.happens(
                engine,
                asking().with("points", ProxyMaps.toValue(points))
                        .with("avoid", new ListValue(List.of(ISLAND)))
                        .of("west", "wide")
                        .effect());

        Map<String, GeoPath> paths = paths(answer(), 0);
        assertThat(clearanceM(paths, "west", at(-100, 0))).isBetween(0.6, 1.0);
        assertThat(clearanceM(paths, "wide", at(-100, 10))).isBetween(5.0, 5.4);
    }

    private static double clearanceM(Map<String, GeoPath> paths, String boat, GeoPoint from) {
        List<GeoPoint> whole = new ArrayList<>(List.of(from));
        whole.addAll(paths.get(boat).points());
        return Water.of(TestWorld.HOME, List.of(ISLAND), Optional.empty()).clearanceM(whole);
    }

    @Test
    void severalWaysAreOfferedTheBestByTheCriterionFirst() {
        world.happens(
                engine,
                asking().with("avoid", new ListValue(List.of(ISLAND)))
                        .markup("Optimize", "criteria", new EnumValue("Criterion", "EXECUTION_SAFETY"))
                        .markup("SelectionOptions", "number", new IntegerValue(3))
                        .of("west", "east")
                        .effect());

        Occurrence answer = answer();
        assertThat(options(answer)).hasSize(2);
        assertClear(paths(answer, 0), 4.9);
        assertThat(lengthM(paths(answer, 1), "west")).isLessThan(lengthM(paths(answer, 0), "west"));
        assertThat(messages())
                .anyMatch(text -> text.contains("Path: Safest path, best for execution safety"))
                .anyMatch(text -> text.matches("Paths, option 1 of 2: west keeps 5\\.\\d m; east keeps .* m"))
                .anyMatch(text -> text.matches("Paths, option 2 of 2: west keeps 0\\.\\d m; east keeps .* m"));
        assertThat(messages())
                .contains("Paths, option 1 of 2: " + text(answer, 0, "kept"))
                .contains("Paths, option 2 of 2: " + text(answer, 1, "kept"));
        assertThat(text(answer, 0, "kept")).matches("west keeps 5\\.\\d m; east keeps .* m.*");
        assertThat(text(answer, 0, "method")).contains("Safest path");
        assertThat(((RealValue) field(answer, 1, "longestM")).value())
                .isCloseTo(lengthM(paths(answer, 1), "west"), within(0.5));
        assertThat(((RealValue) field(answer, 0, "totalLengthM")).value())
                .isGreaterThan(((RealValue) field(answer, 1, "totalLengthM")).value());
    }

    @Test
    void whatASafePathKeepsInAGapAndWhatItCostsIsTold() {
        GeoArea north = box(-20, 8, 20, 300);
        GeoArea south = box(-20, -300, 20, 0); // 8 m between them

        world.happens(
                engine,
                asking().with("avoid", new ListValue(List.of(north, south)))
                        .with("clearance", new RealValue(10))
                        .markup("Optimize", "criteria", new EnumValue("Criterion", "EXECUTION_SAFETY"))
                        .of("west")
                        .effect());

        assertThat(messages())
                .anyMatch(text -> text.matches("Paths: west keeps 10\\.0 m where there is room, [1-4]\\.\\d m near"
                        + " 45\\.\\d{5},10\\.\\d{5}.*"));
    }

    /** A session that was begun with it goes on with the vocabulary in its journal. */
    @Test
    void vocabularyWithoutOptionsOfPathsGetsThePathsAlone() {
        Vocabulary now = TestWorld.VOCABULARY;
        ScriptedEngine earlier = new ScriptedEngine(new Vocabulary(
                now.domain(),
                now.types().values().stream()
                        .filter(type -> !type.name().equals(PathOption.TYPE))
                        .toList(),
                List.copyOf(now.events().values()),
                List.copyOf(now.markups().values()),
                List.copyOf(now.taskClasses().values())));
        TestWorld itsWorld = new TestWorld(earlier);
        itsWorld.addBoat("west", -100, 0);
        itsWorld.run(1);

        itsWorld.happens(earlier, asking().of("west").effect());

        List<Value> options = options(earlier.received("PathResponse").get(0));
        assertThat(options)
                .singleElement()
                .satisfies(paths -> assertThat(last(ProxyMaps.read(paths, GeoPath.class), "west"))
                        .isEqualTo(at(80, 0)));
    }

    @Test
    void aBoatWithoutAWayIsNamedWithItsReasonAndTheOthersGetTheirs() {
        GeoArea around = new GeoArea(ring(80, 0, 12), List.of(ring(80, 0, 8)));

        world.happens(
                engine,
                asking().with("avoid", new ListValue(List.of(around)))
                        .of("west", "east")
                        .effect());

        Occurrence answer = answer();
        assertThat(paths(answer, 0)).containsOnlyKeys("east");
        Map<String, TextValue> noWay = ProxyMaps.read(answer.values().get("noWay"), TextValue.class);
        assertThat(noWay).containsOnlyKeys("west");
        assertThat(noWay.get("west").value()).contains("what is forbidden lies all the way");
        assertThat(messages()).anyMatch(text -> text.matches("Paths: east keeps \\d+\\.\\d m"));
        assertThat(world.operator.messages().messages()).anySatisfy(message -> {
            assertThat(message.text()).startsWith("west: There is no way");
            assertThat(message.priority()).isEqualTo(Priority.HIGH);
            assertThat(message.boats()).containsExactly("west");
        });
    }

    @Test
    void whereNobodyHasAWayThereIsNoOption() {
        world.happens(
                engine,
                asking().with("within", box(-200, -50, -50, 50))
                        .of("west", "ghost")
                        .effect());

        Occurrence answer = answer();
        assertThat(answer.proxies()).containsExactly("west", "ghost");
        assertThat(options(answer)).isEmpty();
        assertThat(messages())
                .satisfiesExactlyInAnyOrder(
                        text -> assertThat(text).contains("west").contains("the goal lies in what is forbidden"),
                        text -> assertThat(text).contains("ghost").contains("position is not known"));
    }

    @Test
    void anAreaThatCrossesItselfIsRefusedWithThePlace() {
        GeoArea bow = new GeoArea(List.of(at(0, 0), at(10, 10), at(10, 0), at(0, 10)), List.of());

        world.happens(
                engine,
                asking().with("avoid", new ListValue(List.of(bow)))
                        .of("west", "ghost")
                        .effect());

        assertThat(engine.inputs)
                .filteredOn(Input.HandlerFailed.class::isInstance)
                .singleElement()
                .satisfies(failed -> assertThat(((Input.HandlerFailed) failed).reason())
                        .contains("No-go area 1 is no simple polygon: it crosses or touches itself at 45.6"));
    }

    private static TestActivations asking() {
        Map<String, GeoPoint> points = new LinkedHashMap<>();
        points.put("west", at(80, 0));
        points.put("east", at(150, 10));
        points.put("ghost", at(0, 0));
        return new TestActivations("PathRequest")
                .with("points", ProxyMaps.toValue(points))
                .with("clearance", new RealValue(5));
    }

    private Occurrence answer() {
        assertThat(engine.received("PathResponse")).hasSize(1);
        Occurrence answer = engine.received("PathResponse").get(0);
        TwoBoatsOnHandlers.assertFitsVocabulary(answer);
        return answer;
    }

    private static List<Value> options(Occurrence answer) {
        return ((ListValue) answer.values().get("options")).items();
    }

    private static Map<String, GeoPath> paths(Occurrence answer, int option) {
        return ProxyMaps.read(field(answer, option, "paths"), GeoPath.class);
    }

    private static Value field(Occurrence answer, int option, String name) {
        return ((RecordValue) options(answer).get(option)).field(name).orElseThrow();
    }

    private static String text(Occurrence answer, int option, String name) {
        return ((TextValue) field(answer, option, name)).value();
    }

    private static GeoPoint last(Map<String, GeoPath> paths, String boat) {
        List<GeoPoint> points = paths.get(boat).points();
        return points.get(points.size() - 1);
    }

    private double lengthM(Map<String, GeoPath> paths, String boat) {
        return Geodesy.lengthM(at(-100, 0), paths.get(boat).points());
    }

    /** The way of the boat in the west goes around the island. */
    private static void assertClear(Map<String, GeoPath> paths, double clearanceM) {
        List<GeoPoint> whole = new ArrayList<>(List.of(at(-100, 0)));
        whole.addAll(paths.get("west").points());
        assertThat(Water.of(TestWorld.HOME, List.of(ISLAND), Optional.empty()).clearanceM(whole))
                .isGreaterThan(clearanceM);
    }

    private List<String> messages() {
        return world.operator.messages().messages().stream()
                .map(OperatorMessage::text)
                .toList();
    }

    private static GeoArea box(double west, double south, double east, double north) {
        return new GeoArea(List.of(at(west, south), at(east, south), at(east, north), at(west, north)), List.of());
    }

    private static List<GeoPoint> ring(double eastM, double northM, double half) {
        return List.of(
                at(eastM - half, northM - half),
                at(eastM + half, northM - half),
                at(eastM + half, northM + half),
                at(eastM - half, northM + half));
    }

    private static GeoPoint at(double eastM, double northM) {
        return Geodesy.offset(TestWorld.HOME, eastM, northM);
    }
}
