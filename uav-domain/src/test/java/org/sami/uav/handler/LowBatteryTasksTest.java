package org.sami.uav.handler;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.sami.boat.link.BatteryLevel;
import org.sami.crw.handler.boat.SessionMemory;
import org.sami.spn.protocol.Token;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.TaskId;

/** Tasks that were allocated to an aircraft whose battery had turned low meanwhile, on the ground. */
class LowBatteryTasksTest {
    private static final List<TaskId> TASKS = List.of(new TaskId(1, "Search 1"), new TaskId(1, "Search 2"));

    private final FlightHandlerHarness harness = new FlightHandlerHarness(1);
    private final TaskFlights tasks = harness.taskFlights();

    LowBatteryTasksTest() {
        harness.listen(tasks);
        harness.pass(5);
    }

    private void charge(double percent) {
        harness.fleet.boat("copter1").orElseThrow().hull().setBatteryPercent(percent);
        harness.pass(5);
    }

    /** The operator accepts that the copter gets the tasks. */
    private void accept() {
        TASKS.forEach(task -> {
            harness.allocation.put(task, "copter1");
            harness.tasks.put(task, Map.of());
        });
        GeoPoint to = harness.flights.position("copter1").orElseThrow();
        harness.activate(
                new FlyToHandler(harness.flights, tasks),
                Map.of("location", Flights.at(to, 20)),
                TASKS.stream().<Token>map(Token.Task::new).toList());
        harness.pass(30);
    }

    @Test
    void tasksOfOneThatTurnedLowAreGivenBackWhereThePlanAllocatesThemAnewAndTheOperatorIsTold() {
        harness.plan = UavRuns.DOMAIN.combined().plan("search");
        harness.place = "fly";
        charge(20.4);
        accept();

        assertThat(harness.allocation).isEmpty();
        assertThat(harness.messages)
                .containsExactly("copter1 stays on the ground, as its battery is low (20 %):"
                        + " Search 1, Search 2 are given back and allocated anew");

        charge(100);
        assertThat(harness.altM("copter1")).isZero();
    }

    /** It has nothing to fly at the moment, as one that has just come home and has not said yet that it is down. */
    @Test
    void oneInTheAirWithALowBatteryIsSentToNoTaskThatThePlanAllocatesAnew() {
        harness.plan = UavRuns.DOMAIN.combined().plan("search");
        harness.place = "fly";
        GeoPoint ground = harness.flights.position("copter1").orElseThrow();
        harness.activate(
                new FlyToHandler(harness.flights, tasks),
                Map.of("location", Flights.at(ground, 20)),
                List.<Token>of(new Token.Proxy("copter1")));
        harness.pass(60);
        charge(30);
        assertThat(harness.altM("copter1")).isGreaterThan(10);
        GeoPoint there = harness.flights.position("copter1").orElseThrow();
        TaskId far = new TaskId(1, "Search 3");
        harness.allocation.put(far, "copter1");
        harness.tasks.put(far, Map.of());
        harness.activate(
                new FlyToHandler(harness.flights, tasks),
                Map.of("location", new GeoPoint(there.latDeg() + 0.002, there.lonDeg(), 20)),
                List.<Token>of(new Token.Task(far)));
        harness.pass(30);

        assertThat(harness.allocation).doesNotContainKey(far);
        assertThat(harness.messages)
                .last()
                .asString()
                .startsWith("copter1 flies to no task any more, as its battery is low (")
                .endsWith("Search 3 is given back and allocated anew");
        assertThat(harness.flights.position("copter1").orElseThrow().latDeg())
                .isCloseTo(there.latDeg(), within(0.0003));
    }

    @Test
    void tasksOfOneThatTurnedLowWaitForABatteryInOtherPlansAndTheOperatorIsTold() {
        charge(15);
        accept();

        assertThat(harness.allocation).hasSize(2);
        assertThat(harness.messages)
                .containsExactly("copter1 stays on the ground, as its battery is critical (15 %):"
                        + " Search 1, Search 2 are kept until it is charged");

        charge(100);
        harness.pass(30);
        assertThat(harness.altM("copter1")).isGreaterThan(10);
        assertThat(harness.messages).hasSize(1);
    }

    @Test
    void afterARestartTasksAreGivenBackOnceTheAircraftHasSaidThatItIsOnTheGround() {
        FlightHandlerHarness restarted = new FlightHandlerHarness(1);
        restarted.plan = UavRuns.DOMAIN.combined().plan("search");
        restarted.place = "fly";
        restarted.isRedelivered = true;
        restarted.post(List.of(SessionMemory.BATTERY.remember("copter1", BatteryLevel.LOW.name())));
        restarted.fleet.boat("copter1").orElseThrow().hull().setBatteryPercent(30);
        TaskFlights flights = restarted.taskFlights();
        restarted.listen(flights);
        TaskId task = TASKS.get(0);
        restarted.allocation.put(task, "copter1");
        restarted.activate(
                new FlyToHandler(restarted.flights, flights),
                Map.of("location", new GeoPoint(45.7, 10.72, 20)),
                List.<Token>of(new Token.Task(task)));
        assertThat(restarted.allocation).isNotEmpty();

        restarted.pass(10);

        assertThat(restarted.allocation).isEmpty();
        assertThat(restarted.flights.position("copter1")).map(GeoPoint::altM).isEqualTo(Optional.of(0.0));
    }
}
