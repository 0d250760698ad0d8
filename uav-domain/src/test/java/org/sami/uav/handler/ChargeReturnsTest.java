package org.sami.uav.handler;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.sami.crw.proxy.command.FollowPath;
import org.sami.crw.proxy.command.KeepStation;
import org.sami.crw.service.Geodesy;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Priority;
import org.sami.spn.value.GeoPoint;

/** Copters that the base itself brings home, as nobody has answered whether they are sent on with their charges. */
class ChargeReturnsTest {
    private static final double ALT_M = 30;
    private static final double AT_HOME_M = 3;

    private final FlightHandlerHarness harness = new FlightHandlerHarness(1);
    private final TaskFlights tasks = harness.taskFlights();
    private final GeoPoint home;

    ChargeReturnsTest() {
        harness.listen(tasks);
        harness.pass(5);
        home = harness.flights.position("copter1").orElseThrow();
    }

    private void flyTo(double northM) {
        GeoPoint to = Flights.at(Geodesy.offset(home, 0, northM), ALT_M);
        harness.activate(new FlyToHandler(harness.flights, tasks), Map.of("location", to), "copter1");
        harness.pass(2);
    }

    /** It is 250 m away in the air, and on its way home. */
    private void comeHome() {
        harness.fleet.boat("copter1").orElseThrow().hull().setBatteryPercent(36);
        harness.pass(5);
        flyTo(250);
        harness.pass(70);
        flyTo(900);
        harness.answerLate();
        harness.pass(3);
        assertThat(harness.altM("copter1")).isGreaterThan(10);
    }

    @Test
    void returnIsRememberedWithTheAnswerAndBeforeTheNextReport() {
        harness.fleet.boat("copter1").orElseThrow().hull().setBatteryPercent(36);
        harness.pass(5);
        flyTo(250);
        harness.pass(70);
        flyTo(900);
        harness.answerLate();

        assertThat(harness.memory).containsKey("charge-return/copter1");
    }

    private double fromHomeM() {
        return Geodesy.distanceM(harness.flights.position("copter1").orElseThrow(), home);
    }

    private void isDownAtHome() {
        harness.pass(90);
        assertThat(harness.altM("copter1")).isZero();
        assertThat(fromHomeM()).isLessThan(AT_HOME_M);
    }

    @Test
    void endOfThePlanDoesNotTakeTheCommandHomeBack() {
        comeHome();
        harness.withdraw();
        harness.motion.withdraw(1, List.of());

        isDownAtHome();
        assertThat(harness.proxy("copter1").commands().current()).isEmpty();
    }

    @Test
    void whatTheCopterHadOfThePlanBeforeIsReplaced() {
        harness.fleet.boat("copter1").orElseThrow().hull().setBatteryPercent(36);
        harness.pass(5);
        flyTo(250);
        harness.pass(10);
        flyTo(900);
        harness.answerLate();

        isDownAtHome();
    }

    @Test
    void copterThatThePlanHasHoverMeanwhileComesHomeAfterwards() {
        comeHome();
        harness.activate(HoverHandler.staying(harness.motion), Map.of(), "copter1");

        isDownAtHome();
        assertThat(harness.answered()).endsWith(UavEvents.HOVERING);
    }

    @Test
    void copterThatThePlanCallsHomeLandsOnceAndThePlanIsTold() {
        comeHome();
        harness.activate(new ReturnHomeHandler(harness.flights), Map.of(), "copter1");

        isDownAtHome();
        assertThat(harness.answered()).endsWith(UavEvents.LANDED);
        harness.pass(60);
        assertThat(harness.altM("copter1")).isZero();
    }

    @Test
    void endOfAPlanThatHadCalledTheCopterHomeBringsItHomeAllTheSame() {
        comeHome();
        harness.activate(new ReturnHomeHandler(harness.flights), Map.of(), "copter1");
        harness.pass(3);
        harness.motion.withdraw(1, List.of());

        isDownAtHome();
    }

    @Test
    void copterThatTheOperatorTakesByHandDoesNotComeHome() {
        comeHome();
        GeoPoint here = harness.flights.position("copter1").orElseThrow();
        harness.proxy("copter1").commands().withdraw(Ids.NONE);
        harness.proxy("copter1")
                .commands()
                .submit(new KeepStation("guided-1", Ids.NONE, Ids.NONE, here, 3, Priority.CRITICAL, false));
        harness.pass(30);
        harness.proxy("copter1").commands().withdraw(Ids.NONE);
        harness.pass(60);

        assertThat(harness.altM("copter1")).isGreaterThan(10);
        assertThat(fromHomeM()).isGreaterThan(50);
    }

    @Test
    void copterThatIsStoppedDoesNotComeHomeAndTheOperatorIsTold() {
        comeHome();
        harness.proxy("copter1").abort("the operator stopped it");
        harness.pass(60);

        assertThat(harness.altM("copter1")).isGreaterThan(10);
        assertThat(harness.messages)
                .endsWith("copter1 could not come home, for which alone its charge lasted: the operator stopped it");
    }

    @Test
    void copterThatTheOperatorSendsKnowinglyGoesThere() {
        comeHome();
        harness.fleet.boat("copter1").orElseThrow().hull().setBatteryPercent(24);
        harness.pass(2);
        flyTo(600);
        harness.answer(true);
        harness.pass(30);

        assertThat(fromHomeM()).isGreaterThan(400);
    }

    /** Another base has it, and lands it where it is. */
    private OtherBase landBySomebodyElse() {
        OtherBase other =
                new OtherBase(harness.clock, harness.fleet.boat("copter1").orElseThrow());
        harness.pass(2);
        other.proxy.handOver().takeCommand();
        harness.pass(2);
        assertThat(harness.proxy("copter1").isCommanding()).isFalse();
        GeoPoint below = Flights.at(harness.flights.position("copter1").orElseThrow(), 0);
        other.proxy.commands().submit(FollowPath.of("land", 1, 1, List.of(below), Priority.HIGH));
        harness.pass(60);
        assertThat(harness.altM("copter1")).isZero();
        assertThat(fromHomeM()).isGreaterThan(50);
        return other;
    }

    @Test
    void copterThatSomebodyElseHasLandedStaysDownWhereThisBaseHasItAgain() {
        comeHome();
        OtherBase other = landBySomebodyElse();
        other.proxy.commands().withdraw(1);
        other.proxy.handOver().observe();
        harness.proxy("copter1").handOver().takeCommand();
        harness.pass(30);

        assertThat(harness.proxy("copter1").isCommanding()).isTrue();
        assertThat(harness.altM("copter1")).isZero();
        assertThat(harness.proxy("copter1").commands().current()).isEmpty();
    }

    @Test
    void copterThatIsDownAfterItsServerHasStartedAnewStaysDownWhereItIsAllowedToMove() {
        comeHome();
        String id = harness.proxy("copter1").commands().current().orElseThrow().commandId();
        harness.proxy("copter1").knownBoot("another start");
        harness.report("copter1", 0);

        assertThat(harness.proxy("copter1").commands().visitedCount(id)).isEmpty();
    }

    @Test
    void commandHomeStaysUntilItsEndWhileTheCopterTouchesDown() {
        comeHome();
        String id = harness.proxy("copter1").commands().current().orElseThrow().commandId();
        harness.report("copter1", 0.4);

        assertThat(harness.proxy("copter1").commands().visitedCount(id)).isPresent();
    }

    @Test
    void whyItComesHomeIsSaidOfIt() {
        comeHome();

        assertThat(harness.proxy("copter1").explain().text())
                .contains("comes home, as its charge lasts for that alone")
                .doesNotContain("operator");
    }
}
