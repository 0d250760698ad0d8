package org.sami.uav.handler;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.sami.crw.event.ProxyMaps;
import org.sami.crw.fleet.FleetEvent;
import org.sami.crw.handler.activation.Addressee;
import org.sami.crw.handler.motion.PathProgress;
import org.sami.crw.proxy.TakenWaypoints;
import org.sami.crw.proxy.status.BoatReading;
import org.sami.crw.service.Geodesy;
import org.sami.crw.sim.hull.HullConfig;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.Token;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPath;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.IntegerValue;
import org.sami.spn.value.ListValue;
import org.sami.spn.value.MapValue;
import org.sami.spn.value.ProxyValue;
import org.sami.spn.value.RealValue;
import org.sami.spn.value.RecordValue;
import org.sami.spn.value.TaskId;
import org.sami.spn.value.TextValue;
import org.sami.spn.value.Value;

class FlightHandlersTest {
    private static final GeoPoint POST = GeoPoint.of(45.7005, 10.7205);
    private static final GeoPoint FAR = GeoPoint.of(45.71, 10.72);
    private static final GeoPath PATH = new GeoPath(List.of(POST, GeoPoint.of(45.7003, 10.7202)));
    private static final Map<String, Value> UP = Map.of("altitude", new RealValue(20));

    private static FlightHandlerHarness harness(int copters) {
        FlightHandlerHarness harness = new FlightHandlerHarness(copters);
        harness.pass(2);
        return harness;
    }

    private static void takeOff(FlightHandlerHarness harness, String... copters) {
        harness.activate(VerticalHandler.climbing(harness.flights, UavEvents.AIRBORNE), UP, copters);
    }

    private static FlyToHandler flyTo(FlightHandlerHarness harness) {
        return new FlyToHandler(harness.flights, harness.taskFlights());
    }

    @Test
    void returnHomeReplacesATakeOffThatHasNotLeftTheGround() {
        FlightHandlerHarness harness = harness(1);
        takeOff(harness, "copter1");
        harness.activate(new ReturnHomeHandler(harness.flights), Map.of(), "copter1");
        harness.pass(60);

        assertThat(harness.answered()).contains(UavEvents.LANDED).doesNotContain(UavEvents.AIRBORNE);
        assertThat(harness.altM("copter1")).isZero();
        assertThat(harness.proxy("copter1").isAtRest()).isTrue();
    }

    @Test
    void returnHomeWaitsInTheAirUntilTheHomeIsKnown() {
        FlightHandlerHarness harness = harness(1);
        takeOff(harness, "copter1");
        harness.pass(60);
        GeoPoint home = harness.proxy("copter1").home().orElseThrow();
        harness.reportHome("copter1", Optional.empty());
        harness.activate(flyTo(harness), Map.of("location", FAR), "copter1");
        harness.pass(5);
        GeoPoint asked = harness.flights.position("copter1").orElseThrow();
        harness.activate(new ReturnHomeHandler(harness.flights), Map.of(), "copter1");
        harness.pass(60);

        assertThat(harness.answered()).containsExactly(UavEvents.AIRBORNE);
        assertThat(harness.altM("copter1")).isGreaterThan(19);
        assertThat(Geodesy.distanceM(asked, harness.flights.position("copter1").orElseThrow()))
                .isLessThan(30);
        assertThat(harness.messages).singleElement().asString().contains("it has not said where it took off");

        harness.reportHome("copter1", Optional.of(home));
        harness.pass(120);
        assertThat(harness.answered()).containsExactly(UavEvents.AIRBORNE, UavEvents.LANDED);
        assertThat(Geodesy.distanceM(home, harness.flights.position("copter1").orElseThrow()))
                .isLessThan(3);
        assertThat(harness.messages).hasSize(1);
    }

    @Test
    void returnHomeOutOfANoGoAreaIsFlownWithoutAQuestion() {
        FlightHandlerHarness harness = harness(1);
        takeOff(harness, "copter1");
        harness.pass(60);
        harness.activate(flyTo(harness), Map.of("location", Flights.at(POST, 8)), "copter1");
        harness.pass(60);
        GeoPoint here = harness.flights.position("copter1").orElseThrow();
        GeoArea around = new GeoArea(
                List.of(
                        Geodesy.offset(here, -20, -20),
                        Geodesy.offset(here, 20, -20),
                        Geodesy.offset(here, 20, 20),
                        Geodesy.offset(here, -20, 20)),
                List.of());
        harness.activate(
                new ReturnHomeHandler(harness.flights), Map.of("avoid", new ListValue(List.of(around))), "copter1");
        harness.pass(90);

        assertThat(harness.answered())
                .containsExactly(UavEvents.AIRBORNE, UavEvents.REACHED_LOCATION, UavEvents.LANDED);
    }

    @Test
    void flightsWaitUntilAircraftHaveSaidWhereTheyAre() {
        FlightHandlerHarness harness = new FlightHandlerHarness(4);
        takeOff(harness, "copter1");
        harness.activate(flyTo(harness), Map.of("location", POST), "copter2");
        harness.activate(VerticalHandler.landing(harness.flights), Map.of(), "copter3");
        harness.activate(new ReturnHomeHandler(harness.flights), Map.of(), "copter4");
        assertThat(harness.answers).isEmpty();
        harness.pass(90);

        assertThat(harness.answered())
                .containsExactlyInAnyOrder(
                        UavEvents.AIRBORNE, UavEvents.REACHED_LOCATION, UavEvents.LANDED, UavEvents.LANDED);
    }

    @Test
    void newerRequestReplacesOneThatWaits() {
        FlightHandlerHarness harness = new FlightHandlerHarness(1);
        harness.activate(VerticalHandler.landing(harness.flights), Map.of(), "copter1");
        takeOff(harness, "copter1");
        harness.pass(60);

        assertThat(harness.answered()).containsExactly(UavEvents.AIRBORNE);
    }

    @Test
    void replacedRequestThatWaitsIsAnsweredWhereItIsAwaited() {
        FlightHandlerHarness harness = new FlightHandlerHarness(1);
        harness.areOpen = true;
        takeOff(harness, "copter1");
        harness.activate(new ReturnHomeHandler(harness.flights), Map.of(), "copter1");

        assertThat(harness.answered()).containsExactly(UavEvents.CANNOT_FLY);
        assertThat(harness.answers.get(0).values())
                .containsEntry("reason", new TextValue("a newer command of the same mission took its place"));
        harness.pass(60);
        assertThat(harness.answered()).containsExactly(UavEvents.CANNOT_FLY, UavEvents.LANDED);
    }

    @Test
    void withdrawnFlightsThatWaitAreNotFlown() {
        FlightHandlerHarness harness = new FlightHandlerHarness(3);
        takeOff(harness, "copter1", "copter2", "copter3");
        harness.withdraw("copter2");
        harness.pass(60);

        assertThat(harness.answered()).containsExactly(UavEvents.AIRBORNE, UavEvents.AIRBORNE);
        assertThat(harness.altM("copter2")).isZero();
    }

    @Test
    void withdrawalWithoutNamesIsOfAllFlightsThatWait() {
        FlightHandlerHarness harness = new FlightHandlerHarness(2);
        takeOff(harness, "copter1", "copter2");
        harness.withdraw();
        harness.pass(60);

        assertThat(harness.answers).isEmpty();
        assertThat(harness.altM("copter1")).isZero();
    }

    @Test
    void whatAnEndPlaceAsksIsFlownWhenTheAircraftHasSaidWhereItIs() {
        FlightHandlerHarness harness = new FlightHandlerHarness(1);
        harness.isOver = true;
        takeOff(harness, "copter1");
        harness.pass(60);

        assertThat(harness.altM("copter1")).isGreaterThan(19);
    }

    @Test
    void flightThatItsOwnStepTookBackDoesNotWait() {
        FlightHandlerHarness harness = new FlightHandlerHarness(1);
        harness.isOver = true;
        harness.motion.takeBack(1, List.of("copter1"), Optional.empty());
        takeOff(harness, "copter1");
        harness.pass(60);

        assertThat(harness.altM("copter1")).isZero();
    }

    @Test
    void nextTaskIsFlownAfterAnotherCommandOfTheAircraft() {
        FlightHandlerHarness harness = harness(1);
        TaskFlights flights = harness.taskFlights();
        harness.listen(flights);
        List<TaskId> tasks = List.of(new TaskId(1, "T1"), new TaskId(1, "T2"));
        harness.activate(
                (activation, context) -> {
                    for (TaskId task : tasks) {
                        Addressee one = new Addressee("copter1", false, List.of(task));
                        List<GeoPoint> to = List.of(Flights.at(task.name().equals("T1") ? FAR : POST, 20));
                        flights.add(activation, context, new Flights.Flight(one, to, Flights.SPEED_MPS));
                    }
                    flights.startWaiting();
                },
                Map.of(),
                tasks.stream().<Token>map(Token.Task::new).toList());
        harness.pass(10);
        harness.activate(HoverHandler.staying(harness.motion), Map.of(), "copter1");
        harness.pass(10);
        assertThat(harness.answered()).containsExactly(UavEvents.HOVERING);
        harness.step(flights, new Input.Received(harness.answers.get(0)));
        harness.pass(60);

        assertThat(harness.answered()).containsExactly(UavEvents.HOVERING, UavEvents.REACHED_LOCATION);
        assertThat(harness.answers.get(1).tasks()).containsExactly(tasks.get(1));
    }

    private static void flyPath(FlightHandlerHarness harness, double altM) {
        Value paths = ProxyMaps.toValue(Map.of("copter1", PATH));
        Map<String, Value> values = Map.of("paths", paths, "altitude", new RealValue(altM));
        harness.activate(new FlyPathHandler(harness.flights), values, "copter1");
    }

    @Test
    void pathAtAnotherAltitudeIsFlownAgain() {
        FlightHandlerHarness harness = harness(1);
        flyPath(harness, 30);
        harness.pass(90);
        assertThat(harness.answered()).containsExactly(UavEvents.PATH_FLOWN);
        flyPath(harness, 60);
        assertThat(harness.answered()).as("it is still to be flown").hasSize(1);
        harness.pass(90);

        assertThat(harness.answered()).containsExactly(UavEvents.PATH_FLOWN, UavEvents.PATH_FLOWN);
        assertThat(harness.altM("copter1")).isGreaterThan(59);
        flyPath(harness, 30);
        assertThat(harness.answered()).as("it was flown before").hasSize(3);
    }

    @Test
    void pathThatAnEarlierVersionRememberedIsNotFlownAgain() {
        FlightHandlerHarness harness = harness(1);
        harness.memory.put(PathProgress.key("copter1", PATH), new IntegerValue(2));
        flyPath(harness, 30);

        assertThat(harness.answered()).containsExactly(UavEvents.PATH_FLOWN);
    }

    @Test
    void unknownAircraftHasNotLanded() {
        FlightHandlerHarness harness = harness(1);
        harness.activate(VerticalHandler.landing(harness.flights), Map.of(), "copter9");

        assertThat(harness.answered()).containsExactly(UavEvents.CANNOT_FLY);
        assertThat(harness.messages).singleElement().asString().contains("it has not said yet where it is");
    }

    @Test
    void vehicleThatDoesNotFlyAnswersThatItCannotLandOrReturn() {
        FlightHandlerHarness harness = new FlightHandlerHarness(1, HullConfig.DEFAULT);
        harness.pass(2);
        harness.activate(VerticalHandler.landing(harness.flights), Map.of(), "boat1");
        harness.activate(new ReturnHomeHandler(harness.flights), Map.of(), "boat1");

        assertThat(harness.answered()).containsExactly(UavEvents.CANNOT_FLY, UavEvents.CANNOT_FLY);
        assertThat(harness.answers.get(1).values()).containsEntry("reason", new TextValue("boat1 does not fly"));
    }

    @Test
    void aircraftThatSinkBesideOneAnotherDoNotWaitForOneAnother() {
        FlightHandlerHarness harness = harness(2);
        takeOff(harness, "copter1", "copter2");
        harness.pass(30);
        TakenWaypoints taken = new TakenWaypoints();
        List<String> told = new ArrayList<>();
        harness.activate(new ReturnHomeHandler(harness.flights), Map.of(), "copter2");
        harness.pass(30);
        harness.activate(new ReturnHomeHandler(harness.flights), Map.of(), "copter1");
        for (int i = 0; i < 40; i++) {
            harness.pass(1);
            taken.look(List.of(harness.proxy("copter1"), harness.proxy("copter2")))
                    .forEach(one -> told.add(one.words()));
        }

        assertThat(harness.answered()).containsOnly(UavEvents.AIRBORNE, UavEvents.LANDED);
        assertThat(harness.answers).hasSize(4);
        assertThat(told).isEmpty();
    }

    @Test
    void searchFromTheGroundIsRefused() {
        FlightHandlerHarness harness = harness(1);
        harness.activate(new SearchAroundHandler(harness.flights, new Sightings()), Map.of(), "copter1");

        assertThat(harness.answered()).containsExactly(UavEvents.CANNOT_FLY);
        assertThat(harness.answers.get(0).values()).containsEntry("reason", new TextValue("it is not in the air"));
    }

    @Test
    void searchGoesOnAroundItsMiddleWithWhatWasSeenBeforeARestartOfTheBase() {
        FlightHandlerHarness harness = harness(1);
        takeOff(harness, "copter1");
        harness.pass(60);
        GeoPoint middle = harness.flights.position("copter1").orElseThrow();
        GeoPoint target = Flights.at(Geodesy.offset(middle, 10, 10), 0);
        Sightings first = new Sightings();
        harness.activate(new SearchAroundHandler(harness.flights, first), Map.of(), "copter1");
        first.accept(new FleetEvent.Measured(
                "copter1",
                new BoatReading(
                        "camera", Sightings.CHANNEL, List.of(7.0, target.latDeg(), target.lonDeg()), "", middle, 0)));
        harness.pass(10);
        assertThat(Geodesy.distanceM(middle, harness.flights.position("copter1").orElseThrow()))
                .as("it is on its ring")
                .isGreaterThan(10);

        harness.restart();
        SearchAroundHandler again = new SearchAroundHandler(harness.flights, new Sightings());
        harness.listen(again);
        harness.activateAgain(again);
        harness.pass(120);

        assertThat(harness.answered()).containsExactly(UavEvents.AIRBORNE, UavEvents.TARGET_SEEN);
        assertThat(harness.answers.get(1).values()).containsEntry("at", target);
        assertThat(Geodesy.distanceM(middle, harness.flights.position("copter1").orElseThrow()))
                .isLessThan(3);
    }

    @Test
    void picturesThatCannotBeTakenAreAnswered() {
        FlightHandlerHarness harness = harness(1);
        harness.activate(HoverHandler.looking(harness.motion), Map.of(), "copter1");
        harness.proxy("copter1").abort("its camera is gone");

        assertThat(harness.answered()).containsExactly(UavEvents.CANNOT_FLY);
    }

    private static TaskDivision division(FlightHandlerHarness harness) {
        return new TaskDivision(
                harness.flights,
                message -> harness.messages.add(message.text()),
                Runnable::run,
                TaskFailuresTest.failures(List.of("copter1"), new ArrayList<>(), new HashMap<>()));
    }

    private static List<Value> allocatedTo(FlightHandlerHarness harness) {
        Value first = ((ListValue)
                        Objects.requireNonNull(harness.answers.get(0).values().get("allocations")))
                .items()
                .get(0);
        return List.copyOf(((MapValue) ((RecordValue) first).field("tasks").orElseThrow())
                .entries()
                .values());
    }

    private static void divideOneTask(FlightHandlerHarness harness, TaskDivision division) {
        TaskId task = new TaskId(1, "Search 1");
        harness.tasks.put(
                task, Map.of("location", harness.flights.position("copter1").orElseThrow()));
        harness.activate(division, Map.of(), List.<Token>of(new Token.Task(task)));
    }

    private static void charge(FlightHandlerHarness harness, String copter, double percent) {
        harness.fleet.boat(copter).orElseThrow().hull().setBatteryPercent(percent);
        harness.pass(5);
    }

    @Test
    void aircraftWhoseBatteryIsLowGetsNoTask() {
        FlightHandlerHarness harness = harness(2);
        charge(harness, "copter1", 20);
        divideOneTask(harness, division(harness));

        assertThat(allocatedTo(harness)).containsExactly(new ProxyValue("copter2"));
    }

    @Test
    void tasksWaitForABatteryWhereAllAreLowAndTheOperatorIsTold() {
        FlightHandlerHarness harness = harness(1);
        charge(harness, "copter1", 20);
        TaskDivision division = division(harness);
        harness.listen(division);
        divideOneTask(harness, division);
        harness.pass(10);

        assertThat(harness.answers).isEmpty();
        assertThat(harness.messages)
                .containsExactly("All batteries are low: the tasks are allocated once one is charged");

        charge(harness, "copter1", 100);
        assertThat(allocatedTo(harness)).containsExactly(new ProxyValue("copter1"));
    }

    /** It is asked before anybody has reported to the new base. */
    @Test
    void tasksThatABaseBeforeThisOneWasToAllocateAreAllocatedOnceAnAircraftSaysWhereItIs() {
        FlightHandlerHarness harness = new FlightHandlerHarness(1);
        harness.restart();
        TaskDivision division = division(harness);
        harness.listen(division);
        TaskId task = new TaskId(1, "Search 1");
        harness.tasks.put(task, Map.of("location", GeoPoint.of(45.7, 10.72)));
        harness.activate(division, Map.of(), List.<Token>of(new Token.Task(task)));
        assertThat(harness.answers).isEmpty();

        harness.pass(10);

        assertThat(allocatedTo(harness)).containsExactly(new ProxyValue("copter1"));
        assertThat(harness.messages).isEmpty();
    }

    @Test
    void divisionWithTheShorterLongestWayIsFirstWithItsFieldsAsDeclared() {
        FlightHandlerHarness harness = harness(1);
        GeoPoint here = harness.flights.position("copter1").orElseThrow();
        for (int northM : List.of(-15, 10, 30)) {
            TaskId task = new TaskId(1, "Search " + northM);
            harness.tasks.put(task, Map.of("location", Geodesy.offset(here, 0, northM)));
        }
        harness.activate(
                division(harness),
                Map.of(),
                List.of(-15, 10, 30).stream()
                        .<Token>map(northM -> new Token.Task(new TaskId(1, "Search " + northM)))
                        .toList());

        List<Value> options = ((ListValue)
                        Objects.requireNonNull(harness.answers.get(0).values().get("allocations")))
                .items();
        assertThat(options)
                .extracting(option -> ((RecordValue) option).fields().get("method"))
                .containsExactly(new TextValue("the nearest"), new TextValue("short ways for all"));
        assertThat(options)
                .allSatisfy(option -> assertThat(((RecordValue) option).fields().keySet())
                        .containsExactly("tasks", "longestM", "method"));
    }
}
