package org.sami.uav.handler;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Objects;
import java.util.OptionalDouble;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.sami.crw.handler.activation.Addressee;
import org.sami.crw.handler.motion.Reply;
import org.sami.crw.proxy.command.FollowPath;
import org.sami.crw.service.Geodesy;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.Occurrence;
import org.sami.spn.protocol.Priority;
import org.sami.spn.protocol.Token;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.ListValue;
import org.sami.spn.value.MapValue;
import org.sami.spn.value.ProxyValue;
import org.sami.spn.value.RecordValue;
import org.sami.spn.value.TaskId;
import org.sami.spn.value.Value;

/** Tasks at which aircraft fail again and again. */
class TaskFailuresTest {
    private static final TaskId TASK = new TaskId(1, "Search 1");

    private final FlightHandlerHarness harness = new FlightHandlerHarness(2);
    private final List<TaskId> impossible = new ArrayList<>();
    private final Map<TaskId, Map<String, TaskFailures.Failed>> kept = new HashMap<>();
    private final TaskFailures failures = failures(List.of("copter1", "copter2"));
    private final TaskDivision division =
            new TaskDivision(harness.flights, message -> harness.messages.add(message.text()), Runnable::run, failures);

    private TaskFailures failures(List<String> aircraft) {
        return failures(aircraft, impossible, kept);
    }

    /** Of some aircraft; tasks that none can do are listed, and failures kept. */
    static TaskFailures failures(
            List<String> aircraft, List<TaskId> impossible, Map<TaskId, Map<String, TaskFailures.Failed>> kept) {
        return new TaskFailures(
                Runnable::run,
                new TaskFailures.Impossible() {
                    @Override
                    public List<String> aircraft() {
                        return aircraft;
                    }

                    @Override
                    public void became(TaskId task) {
                        impossible.add(task);
                    }
                },
                new TaskFailures.Memory() {
                    @Override
                    public Map<String, TaskFailures.Failed> of(TaskId task) {
                        return kept.getOrDefault(task, Map.of());
                    }

                    @Override
                    public void keep(TaskId task, Map<String, TaskFailures.Failed> failed) {
                        kept.put(task, Map.copyOf(failed));
                    }
                });
    }

    @BeforeEach
    void linkThemAll() {
        harness.listen(failures);
        harness.listen(division);
        harness.pass(5);
        harness.tasks.put(
                TASK, Map.of("location", harness.flights.position("copter1").orElseThrow()));
    }

    private void divide() {
        harness.answers.clear();
        harness.activate(division, Map.of(), List.of(new Token.Task(TASK)));
    }

    private void fail(String copter, int times) {
        harness.allocation.put(TASK, copter);
        for (int i = 0; i < times; i++) {
            harness.step(
                    failures,
                    new Input.Received(new Occurrence(UavEvents.CANNOT_FLY, 1, 1, List.of(), List.of(TASK), Map.of())));
        }
    }

    private Value allocatedTo() {
        Value all = Objects.requireNonNull(harness.answers.get(0).values().get("allocations"));
        RecordValue best = (RecordValue) ((ListValue) all).items().get(0);
        return ((MapValue) best.field("tasks").orElseThrow())
                .entries()
                .values()
                .iterator()
                .next();
    }

    private void charge(String copter, double percent) {
        harness.fleet.boat(copter).orElseThrow().hull().setBatteryPercent(percent);
        harness.pass(5);
    }

    @Test
    void taskGoesToAnotherThatHasNotFailedAtIt() {
        divide();
        assertThat(allocatedTo()).isEqualTo(new ProxyValue("copter1"));

        fail("copter1", 1);
        divide();
        assertThat(allocatedTo()).isEqualTo(new ProxyValue("copter2"));

        fail("copter2", 1);
        divide();
        assertThat(allocatedTo()).isEqualTo(new ProxyValue("copter1"));
    }

    @Test
    void taskAtWhichAllHaveFailedTwiceIsImpossibleAndNotAllocated() {
        fail("copter1", 2);
        assertThat(impossible).isEmpty();
        fail("copter2", 2);
        assertThat(impossible).containsExactly(TASK);
        divide();

        assertThat(harness.answers).isEmpty();
    }

    @Test
    void aircraftWithAnotherBatteryTriesAgain() {
        charge("copter1", 60);
        fail("copter1", 2);
        fail("copter2", 2);
        charge("copter1", 100);
        divide();

        assertThat(allocatedTo()).isEqualTo(new ProxyValue("copter1"));
    }

    @Test
    void taskAtWhichTheChargedOnesHaveFailedWaitsForTheOtherOne() {
        charge("copter2", 20);
        fail("copter1", 2);
        divide();
        assertThat(harness.answers).isEmpty();

        charge("copter2", 100);
        assertThat(allocatedTo()).isEqualTo(new ProxyValue("copter2"));
    }

    @Test
    void operatorIsToldOnceThatATaskWaitsForALowOneAsTheChargedOnesHaveFailed() {
        charge("copter2", 20);
        fail("copter1", 2);
        divide();
        harness.pass(60);
        assertThat(impossible).isEmpty();

        GeoPoint there = at("copter1");
        assertThat(harness.messages)
                .containsExactly(String.format(
                        Locale.ROOT,
                        "Search 1 at %.5f,%.5f waits: copter1 failed at it twice, and the battery of copter2 is low. It is"
                                + " allocated once copter2 is charged, or copter1 has another battery",
                        there.latDeg(),
                        there.lonDeg()));
    }

    @Test
    void operatorIsToldAgainWhereTheTaskWaitsAgain() {
        charge("copter2", 20);
        fail("copter1", 2);
        divide();
        charge("copter2", 100);
        fail("copter2", 1);
        charge("copter2", 20);
        divide();

        assertThat(harness.messages).hasSize(2);
    }

    @Test
    void operatorIsToldWhereTheLowOneForWhichATaskWaitsIsDropped() {
        charge("copter2", 20);
        fail("copter1", 2);
        divide();
        harness.dropped.add("copter2");
        harness.pass(10);

        assertThat(harness.messages)
                .hasSize(2)
                .last()
                .asString()
                .endsWith("copter1 failed at it twice, and there is no other. It is allocated once copter1 has another"
                        + " battery");
    }

    @Test
    void nobodyIsToldOfATaskThatAChargedOneMayTry() {
        charge("copter2", 20);
        fail("copter1", 1);
        divide();

        assertThat(harness.messages).isEmpty();
        assertThat(allocatedTo()).isEqualTo(new ProxyValue("copter1"));
    }

    @Test
    void batteryThatWasChangedBeforeTheNextBaseBegunCountsAsAnotherOne() {
        charge("copter1", 60);
        fail("copter1", 2);
        TaskFailures next = failures(List.of("copter1"));
        assertThat(next.candidates(TASK, List.of("copter1"))).isEmpty();

        harness.listen(next);
        charge("copter1", 100);
        assertThat(next.candidates(TASK, List.of("copter1"))).containsExactly("copter1");

        TaskFailures later = failures(List.of("copter1"));
        assertThat(later.candidates(TASK, List.of("copter1"))).containsExactly("copter1");
    }

    @Test
    void failuresAtALaterTaskWithLessChargeCountForTheNextBaseToo() {
        TaskId later = new TaskId(1, "Search 2");
        kept.put(TASK, Map.of("copter1", new TaskFailures.Failed(2, OptionalDouble.of(90))));
        kept.put(later, Map.of("copter1", new TaskFailures.Failed(2, OptionalDouble.of(60))));
        TaskFailures next = failures(List.of("copter1"));

        assertThat(next.isOut(TASK, "copter1")).isTrue();
        assertThat(next.isOut(later, "copter1")).isTrue();
        harness.listen(next);
        charge("copter1", 58);
        assertThat(next.isOut(TASK, "copter1")).isTrue();
        assertThat(next.isOut(later, "copter1")).isTrue();
    }

    @Test
    void anotherBatteryThatWasReportedBeforeTheFailuresWereLookedUpCounts() {
        kept.put(TASK, Map.of("copter1", new TaskFailures.Failed(2, OptionalDouble.of(60))));
        TaskFailures next = failures(List.of("copter1"));
        harness.listen(next);
        charge("copter1", 100);

        assertThat(next.isOut(TASK, "copter1")).isFalse();
    }

    @Test
    void planThatHasNoTasksToAllocateIsAnswered() {
        harness.activate(division, Map.of(), List.of());

        assertThat(harness.answered()).containsExactly(UavEvents.ALLOCATIONS_COMPUTED);
    }

    @Test
    void aircraftThatMoreUrgentCommandsTookHasNotFailed() {
        for (String copter : List.of("copter1", "copter2")) {
            harness.allocation.put(TASK, copter);
            flyAndTakeTwice(copter);
            assertThat(harness.answered()).containsOnly(UavEvents.CANNOT_FLY).hasSize(2);
            harness.answers.forEach(answer -> harness.step(failures, new Input.Received(answer)));
            harness.answers.clear();
        }

        assertThat(impossible).isEmpty();
        divide();
        assertThat(harness.answers).hasSize(1);
    }

    private GeoPoint at(String copter) {
        return harness.flights.position(copter).orElseThrow();
    }

    private void flyAndTakeTwice(String copter) {
        for (int i = 0; i < 2; i++) {
            Addressee one = new Addressee(copter, false, List.of(TASK));
            List<GeoPoint> way = List.of(Flights.at(Geodesy.offset(at(copter), 0, 300), 30));
            harness.activate(
                    (activation, context) -> harness.motion.send(
                            activation,
                            context,
                            List.of(Flights.move(
                                    activation,
                                    context,
                                    new Flights.Flight(one, way, Flights.SPEED_MPS),
                                    Reply.way(UavEvents.REACHED_LOCATION, UavEvents.CANNOT_FLY),
                                    ""))),
                    Map.of(),
                    List.of(new Token.Task(TASK)));
            harness.pass(3);
            harness.proxy(copter)
                    .commands()
                    .submit(FollowPath.of("urgent-" + copter + i, 2, 1, List.of(at(copter)), Priority.HIGH));
            harness.pass(10);
        }
    }
}
