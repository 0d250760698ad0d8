package org.sami.uav.handler;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.sami.crw.handler.activation.Addressee;
import org.sami.crw.handler.motion.Reply;
import org.sami.crw.service.Geodesy;
import org.sami.crw.service.reach.Endurance;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.Token;
import org.sami.spn.value.GeoPath;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.MapValue;
import org.sami.spn.value.ProxyValue;
import org.sami.spn.value.RealValue;
import org.sami.spn.value.TaskId;
import org.sami.spn.value.Value;

/** Copters that are sent on flights for which their charges do not last are asked about before they fly. */
class FlightChargesTest {
    private static final double ALT_M = 30;

    private final FlightHandlerHarness harness = new FlightHandlerHarness(1);
    private final TaskFlights tasks = harness.taskFlights();
    private final GeoPoint home;

    FlightChargesTest() {
        harness.listen(tasks);
        harness.pass(5);
        home = harness.flights.position("copter1").orElseThrow();
    }

    private void charge(double percent) {
        harness.fleet.boat("copter1").orElseThrow().hull().setBatteryPercent(percent);
        harness.pass(5);
    }

    private GeoPoint north(double metres) {
        return Flights.at(Geodesy.offset(home, 0, metres), ALT_M);
    }

    private void flyTo(double northM) {
        harness.activate(new FlyToHandler(harness.flights, tasks), Map.of("location", north(northM)), "copter1");
        harness.pass(2);
    }

    private List<String> asked() {
        return harness.asked.stream().map(Input.AskOperator::prompt).toList();
    }

    @Test
    void flightThatTheChargeLastsForIsFlownWithoutAQuestion() {
        charge(50);
        flyTo(800);
        harness.pass(30);

        assertThat(asked()).isEmpty();
        assertThat(harness.altM("copter1")).isGreaterThan(20);
    }

    @Test
    void copterWhoseChargeDoesNotLastWaitsForTheOperatorAndFliesOnAYes() {
        charge(30);
        flyTo(800);
        harness.pass(30);

        assertThat(asked())
                .singleElement()
                .asString()
                .matches("copter1 needs 2\\d\\d s of flight, 1\\d\\d s of them to come home and land, and its charge of"
                        + " 30 % lasts 1\\d\\d s until 20 %, if a full battery lasts 25 minutes in the air, as nothing"
                        + " else was seen of it yet. Send it\\?");
        assertThat(harness.asked.get(0).kind()).isEqualTo("LongWay");
        assertThat(harness.altM("copter1")).isZero();

        harness.answer(true);
        harness.pass(30);
        assertThat(harness.altM("copter1")).isGreaterThan(20);
        assertThat(harness.answers).isEmpty();
    }

    @Test
    void copterThatTheOperatorDoesNotSendStaysAndThePlanIsTold() {
        charge(30);
        flyTo(800);
        harness.answer(false);
        harness.pass(30);

        assertThat(harness.altM("copter1")).isZero();
        assertThat(harness.answered()).containsExactly(UavEvents.CANNOT_FLY);
        assertThat(harness.messages.get(0)).contains("the operator does not want it: copter1 needs");
    }

    @Test
    void baseThatGoesOnDoesNotAskAgain() {
        charge(30);
        FlyToHandler handler = new FlyToHandler(harness.flights, tasks);
        harness.activate(handler, Map.of("location", north(800)), "copter1");
        harness.answer(false);
        harness.restart();
        harness.activateAgain(handler);
        harness.pass(30);

        assertThat(asked()).hasSize(1);
        assertThat(harness.altM("copter1")).isZero();
    }

    @Test
    void questionThatWasOpenIsAskedAgainByABaseThatGoesOn() {
        charge(30);
        FlyToHandler handler = new FlyToHandler(harness.flights, tasks);
        harness.activate(handler, Map.of("location", north(800)), "copter1");
        harness.restart();
        harness.activateAgain(handler);
        assertThat(asked()).hasSize(2);
        harness.answer(true);
        harness.pass(30);

        assertThat(harness.altM("copter1")).isGreaterThan(20);
    }

    @Test
    void lanesAndSearchesAndTakeOffsAreCheckedToo() {
        charge(30);
        Value path = new GeoPath(List.of(north(800), north(0)));
        harness.activate(
                new FlyPathHandler(harness.flights),
                Map.of("paths", new MapValue(Map.of(new ProxyValue("copter1"), path))),
                "copter1");
        assertThat(asked()).hasSize(1);
        harness.answer(false);

        charge(20.2);
        harness.activate(
                VerticalHandler.climbing(harness.flights, UavEvents.AIRBORNE),
                Map.of("altitude", new RealValue(20)),
                "copter1");
        assertThat(asked()).hasSize(2);
        harness.answer(false);

        charge(60);
        flyTo(50);
        harness.pass(60);
        charge(20.2);
        Sightings sightings = new Sightings();
        harness.activate(new SearchAroundHandler(harness.flights, sightings), Map.of(), "copter1");
        assertThat(asked()).hasSize(3);
        harness.answer(false);

        harness.activate(HoverHandler.looking(harness.motion), Map.of(), "copter1");
        assertThat(asked()).hasSize(4);
    }

    @Test
    void copterIsAlwaysToComeHomeAndLand() {
        charge(60);
        flyTo(200);
        harness.pass(60);
        charge(8);
        harness.activate(new ReturnHomeHandler(harness.flights), Map.of(), "copter1");
        harness.pass(90);

        assertThat(asked()).isEmpty();
        assertThat(harness.altM("copter1")).isZero();
    }

    @Test
    void whatWasSeenOfTheCopterInTheAirCountsAfterwards() {
        charge(90);
        flyTo(100);
        harness.pass(120);

        Endurance endurance = harness.proxy("copter1").endurance().orElseThrow();
        assertThat(endurance.isSeen()).isTrue();
        assertThat(endurance.percentPerS()).isBetween(0.9 / 15, 1.1 / 15);

        charge(21);
        flyTo(800);
        assertThat(asked()).singleElement().asString().doesNotContain("nothing else was seen");
    }

    @Test
    void newerOrderTakesThePlaceOfOneThatWaitsForTheOperator() {
        charge(60);
        flyTo(50);
        harness.pass(60);
        charge(25);
        flyTo(800);
        assertThat(asked()).hasSize(1);

        harness.activate(new ReturnHomeHandler(harness.flights), Map.of(), "copter1");
        harness.pass(60);
        harness.answer(true);
        harness.pass(60);

        assertThat(harness.altM("copter1")).isZero();
    }

    @Test
    void nextTaskWaitsWhileTheOperatorIsAskedAboutTheOneBeforeIt() {
        charge(36);
        flyTasks(Map.of("Far", 900.0, "Near", 20.0), List.of("Far", "Near"));
        assertThat(asked()).hasSize(1);
        assertThat(harness.altM("copter1")).isZero();

        harness.answer(false);
        harness.pass(30);
        assertThat(harness.answered()).containsExactly(UavEvents.CANNOT_FLY, UavEvents.REACHED_LOCATION);
        assertThat(Stream.of("copter1").map(harness::altM)).allMatch(altM -> altM > 10);
    }

    @Test
    void answerAboutOneTaskIsNoneAboutTheNext() {
        charge(36);
        flyTasks(Map.of("Far", 900.0, "Farther", 1000.0), List.of("Far", "Farther"));

        harness.answer(false);
        harness.pass(30);

        assertThat(asked()).hasSize(2);
        assertThat(asked().get(1)).isNotEqualTo(asked().get(0));
        assertThat(harness.answered()).containsExactly(UavEvents.CANNOT_FLY);
    }

    @Test
    void placeThatIsFarAwayAndAChargeThatDoesNotLastAreOneQuestion() {
        charge(60);
        flyTo(7_000);

        assertThat(asked()).singleElement().asString().contains("copter1 is to go 7.0 km", "; copter1 needs ");
    }

    @Test
    void questionOnTheGroundWaitsWithoutEnd() {
        charge(30);
        flyTo(800);

        assertThat(harness.asked)
                .singleElement()
                .satisfies(one -> assertThat(one.unanswered()).isEmpty());
    }

    @Test
    void questionInTheAirWaitsNoLongerThanTheChargeLastsForTheWayHome() {
        askInTheAir();

        assertThat(harness.asked).singleElement().satisfies(one -> {
            assertThat(one.unanswered().orElseThrow().yes()).isFalse();
            assertThat(one.unanswered().orElseThrow().afterMillis() / 1000.0)
                    .isBetween(90.0, 130.0); // 9 % last about 135 s, and the way home takes 26 s
            assertThat(one.prompt()).matches(".*Send it\\? Without an answer it comes home after \\d+ s, while.*");
        });
    }

    @Test
    void copterInTheAirThatNobodyAnswersAboutComesHomeWithItsReserveAndThePlanIsTold() {
        askInTheAir();
        harness.answerLate();
        for (int s = 0; s < 60 && harness.altM("copter1") > 0; s++) {
            harness.pass(1);
        }

        assertThat(harness.altM("copter1")).isZero();
        assertThat(Geodesy.distanceM(harness.flights.position("copter1").orElseThrow(), home))
                .isLessThan(3);
        assertThat(harness.fleet.boat("copter1").orElseThrow().hull().batteryPercent())
                .isBetween(19.0, 22.0);
        assertThat(harness.answered()).endsWith(UavEvents.CANNOT_FLY);
        assertThat(String.join("\n", harness.messages))
                .contains("nobody has answered in time, and it comes home while its charge lasts: copter1 needs");
    }

    /** The base ended before its plan had heard of it. */
    @Test
    void baseThatGoesOnSaysThatNobodyAnsweredAndNotThatTheOperatorDoesNotWantIt() {
        askInTheAir();
        harness.answerLate();
        harness.memory.keySet().removeIf(key -> key.startsWith("command/"));
        harness.messages.clear();
        harness.restart();
        harness.activateAgain(new FlyToHandler(harness.flights, tasks));
        harness.pass(2);

        assertThat(harness.messages)
                .singleElement()
                .asString()
                .endsWith("asked: nobody answered in time whether it is sent");
        assertThat(asked()).hasSize(1);
    }

    @Test
    void flightAboutWhichNobodyAnsweredIsAskedAboutAnewWhereTheOperatorHasItSentAgain() {
        askInTheAir();
        harness.answerLate();
        harness.restart();
        harness.isOrderedAgain = true;
        harness.activateAgain(new FlyToHandler(harness.flights, tasks));
        harness.pass(2);

        assertThat(asked()).hasSize(2);
    }

    @Test
    void copterWhoseChargeFallsFasterThanWasThoughtComesHomeBeforeItsQuestionEnds() {
        askInTheAir();
        charge(21);
        harness.pass(60);

        assertThat(harness.altM("copter1")).isZero();
        assertThat(harness.answered()).endsWith(UavEvents.CANNOT_FLY);
        assertThat(harness.withdrawn).hasSize(1);
    }

    @Test
    void copterWaitsOnWhereTheOperatorHasStoppedTheTimer() {
        askInTheAir();
        harness.stopTimer();
        charge(21);
        harness.pass(60);

        assertThat(harness.altM("copter1")).isPositive();
        assertThat(harness.withdrawn).isEmpty();
    }

    /** The question on the ground has no deadline, and the one in the air waits for it. */
    @Test
    void copterInTheAirWhoseQuestionWaitsForAnotherComesHomeAsWell() {
        charge(29);
        flyTo(50);
        harness.pass(60);
        TaskId far = task("Far", 900);
        TaskId farther = task("Farther", 950);
        harness.activate(
                (activation, context) -> {
                    for (TaskId task : List.of(far, farther)) {
                        Addressee one = new Addressee("copter1", false, List.of(task));
                        harness.motion.send(
                                activation,
                                context,
                                List.of(Flights.move(
                                        activation,
                                        context,
                                        new Flights.Flight(one, List.of(north(950)), Flights.SPEED_MPS),
                                        Reply.way(UavEvents.REACHED_LOCATION, UavEvents.CANNOT_FLY),
                                        "-" + task.name())));
                    }
                },
                Map.of(),
                List.of(new Token.Task(far), new Token.Task(farther)));
        assertThat(asked()).hasSize(1);
        harness.pass(120);

        assertThat(harness.altM("copter1")).isZero();
        assertThat(harness.answered()).endsWith(UavEvents.CANNOT_FLY);
    }

    @Test
    void oneAnswerHoldsForTheWayToATaskAndForTheSearchThere() {
        searchTheFarTask();

        assertThat(asked()).hasSize(1);
        assertThat(harness.answered()).containsExactly(UavEvents.REACHED_LOCATION, UavEvents.NOTHING_SEEN);
    }

    @Test
    void chargeThatHasBecomeClearlyWorseIsAskedAboutOnceMore() {
        flyToTheFarTask();
        charge(25);
        search();

        assertThat(asked()).hasSize(2);
    }

    @Test
    void copterThatWasDownIsAskedAboutForItsNextFlight() {
        searchTheFarTask();
        harness.activate(new ReturnHomeHandler(harness.flights), Map.of(), "copter1");
        harness.pass(200);
        assertThat(harness.altM("copter1")).isZero();
        charge(36);
        flyTasks(Map.of("Far", 900.0), List.of("Far"));

        assertThat(asked()).hasSize(2);
    }

    private void askInTheAir() {
        charge(33);
        flyTo(50);
        harness.pass(60);
        flyTo(800);
    }

    private void flyToTheFarTask() {
        charge(36);
        flyTasks(Map.of("Far", 900.0), List.of("Far"));
        harness.answer(true);
        harness.pass(150);
        assertThat(harness.answered()).containsExactly(UavEvents.REACHED_LOCATION);
    }

    private void search() {
        SearchAroundHandler handler = new SearchAroundHandler(harness.flights, new Sightings());
        harness.listen(handler);
        harness.activate(handler, Map.of(), List.of(new Token.Task(new TaskId(1, "Far"))));
    }

    private void searchTheFarTask() {
        flyToTheFarTask();
        search();
        harness.pass(120);
    }

    private TaskId task(String name, double northM) {
        TaskId task = new TaskId(1, name);
        harness.allocation.put(task, "copter1");
        harness.tasks.put(task, Map.of("location", north(northM)));
        return task;
    }

    /** One activation has the copter fly to tasks one after another, each so far to the north. */
    private void flyTasks(Map<String, Double> metres, List<String> names) {
        List<TaskId> all =
                names.stream().map(name -> task(name, metres.get(name))).toList();
        harness.activate(
                (activation, context) -> {
                    for (TaskId task : all) {
                        tasks.add(
                                activation,
                                context,
                                new Flights.Flight(
                                        new Addressee("copter1", false, List.of(task)),
                                        List.of(north(metres.get(task.name()))),
                                        Flights.SPEED_MPS));
                    }
                    tasks.startWaiting();
                },
                Map.of(),
                all.stream().<Token>map(Token.Task::new).toList());
        harness.pass(30);
    }
}
