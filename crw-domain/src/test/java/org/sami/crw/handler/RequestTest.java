package org.sami.crw.handler;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.SortedMap;
import java.util.TreeMap;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.sami.boat.link.BoatPerformance;
import org.sami.boat.link.TrackingError;
import org.sami.crw.event.Allocation;
import org.sami.crw.event.ProxyMaps;
import org.sami.crw.handler.activation.EventNames;
import org.sami.crw.message.OperatorMessage;
import org.sami.crw.service.Geodesy;
import org.sami.spn.engine.MissionView;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.MissionStatus;
import org.sami.spn.protocol.Occurrence;
import org.sami.spn.protocol.Priority;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.ListValue;
import org.sami.spn.value.RealValue;
import org.sami.spn.value.TaskId;
import org.sami.spn.value.TextValue;
import org.sami.spn.value.TypeCheck;
import org.sami.spn.value.Value;
import org.sami.spn.vocabulary.Direction;
import org.sami.spn.vocabulary.EventType;

/** Requests to services, messages, and news of boats. */
class RequestTest {
    private final ScriptedEngine engine = new ScriptedEngine(TestWorld.VOCABULARY);
    private final TestWorld world = new TestWorld(engine);

    @BeforeEach
    void twoBoats() {
        world.addBoat("west", -100, 0);
        world.addBoat("east", 100, 0);
        world.run(1);
    }

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

    @Test
    void aBoatsDistanceIsComparedWithTheThreshold() {
        Value points = ProxyMaps.toValue(Map.of("west", at(-100, 30), "east", at(100, 3)));

        world.happens(
                engine,
                new TestActivations("ProxyCompareDistanceRequest")
                        .with("location", points)
                        .with("distance", new RealValue(10))
                        .of("west", "east")
                        .effect());

        assertThat(only("QuantityGreater").proxies()).containsExactly("west");
        assertThat(only("QuantityLess").proxies()).containsExactly("east");
    }

    @Test
    void aBoatWithoutAPointDoesNotKeepTheOthersFromTheirAnswers() {
        Value points = ProxyMaps.toValue(Map.of("east", at(100, 3)));

        world.happens(
                engine,
                new TestActivations("ProxyCompareDistanceRequest")
                        .with("location", points)
                        .with("distance", new RealValue(10))
                        .of("west", "east")
                        .effect());

        assertThat(only("QuantityLess").proxies()).containsExactly("east");
        assertThat(engine.inputs)
                .filteredOn(Input.HandlerFailed.class::isInstance)
                .singleElement()
                .satisfies(failed ->
                        assertThat(((Input.HandlerFailed) failed).reason()).contains("west"));
    }

    @Test
    void aMessageReachesTheOperatorWithItsMarkups() {
        world.happens(
                engine,
                new TestActivations("DisplayMessage")
                        .with("message", new TextValue("All locations visited"))
                        .markup("Keyword", "source", new TextValue("done"))
                        .priority(Priority.HIGH)
                        .of("east")
                        .effect());

        OperatorMessage message = world.operator.messages().messages().get(0);
        assertThat(message.text()).isEqualTo("All locations visited");
        assertThat(message.boats()).containsExactly("east");
        assertThat(message.keyword()).isEqualTo("done");
        assertThat(message.priority()).isEqualTo(Priority.HIGH);
    }

    @Test
    void aBoatJoinsOnceWhenItsLinkIsUp() {
        world.cutLinks(true);
        world.run(6);
        world.cutLinks(false);
        world.run(6);

        assertThat(engine.proxies()).containsExactly("west", "east");
        assertThat(engine.received("ProxyCreated"))
                .extracting(Occurrence::proxies)
                .containsExactly(List.of("west"), List.of("east"));
        assertThat(messages()).anyMatch(text -> text.contains("east is back"));
    }

    @Test
    void lossesOfALinkThatIsLostAgainAndAgainAreCounted() {
        SortedMap<Long, String> told = new TreeMap<>();
        world.operator
                .messages()
                .addListener(entries -> entries.forEach(
                        entry -> told.put(entry.number(), entry.message().text())));
        for (int i = 0; i < 3; i++) {
            world.cutLinks(true);
            world.run(6);
            world.cutLinks(false);
            world.run(6);
        }

        assertThat(told.values())
                .filteredOn(text -> text.contains("link to east"))
                .hasSize(6)
                .contains("The link to east is lost; its commands wait", "The link to east is back")
                .anyMatch(text -> text.matches("The link to east is lost again, 3 times in \\d+ s; its commands wait"))
                .last()
                .asString()
                .matches("The link to east is back; it was lost 3 times in \\d+ s");
    }

    @Test
    void posesAreInputsOnlyWhileATransitionWaitsForThem() {
        world.run(5);
        assertThat(engine.received("ProxyPoseUpdated")).isEmpty();

        engine.awaited.add("ProxyPoseUpdated");
        world.host.post(new Input.TimeReached());
        world.run(2);

        assertThat(engine.received("ProxyPoseUpdated"))
                .extracting(Occurrence::proxies)
                .contains(List.of("west"), List.of("east"));
    }

    @Test
    void aBatteryIsNewsWhenItsClassChanges() {
        int nominal = engine.received("BatteryNominal").size();
        world.hull("east").setBatteryPercent(1);
        world.run(3);
        world.hull("east").setBatteryPercent(0.5);
        world.run(3);

        assertThat(nominal).isEqualTo(2);
        assertThat(engine.received("BatteryCritical")).singleElement().satisfies(news -> {
            assertThat(news.proxies()).containsExactly("east");
            assertThat(news.values()).containsEntry("percent", new RealValue(1));
            assertFitsVocabulary(news);
        });
    }

    static void assertFitsVocabulary(Occurrence occurrence) {
        EventType type = TestWorld.VOCABULARY.event(occurrence.type()).orElseThrow();
        occurrence
                .values()
                .forEach((field, value) -> assertThat(TypeCheck.accepts(
                                type.field(field).orElseThrow().type(), value, TestWorld.VOCABULARY.types()))
                        .as(field)
                        .isTrue());
        assertThat(occurrence.values()).hasSameSizeAs(type.fields());
    }

    private Occurrence only(String type) {
        assertThat(engine.received(type)).hasSize(1);
        return engine.received(type).get(0);
    }

    private List<String> messages() {
        return world.operator.messages().messages().stream()
                .map(OperatorMessage::text)
                .toList();
    }

    private static GeoPoint point(Occurrence answer, String boat) {
        return ProxyMaps.read(answer.values().get("points"), GeoPoint.class).get(boat);
    }

    private static GeoPoint at(double eastM, double northM) {
        return Geodesy.offset(TestWorld.HOME, eastM, northM);
    }
}
