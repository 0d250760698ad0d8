package org.sami.crw.operator;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.sami.crw.area.OperatingArea;
import org.sami.crw.operator.alarm.Alarm;
import org.sami.crw.operator.health.Health;
import org.sami.crw.operator.health.HealthEntry;
import org.sami.crw.operator.health.HealthFault;
import org.sami.crw.operator.health.HealthKind;
import org.sami.spn.protocol.Priority;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPoint;

/** What is in a session's health, since when and until when. */
class HealthModelTest {
    private static final HealthFault FULL = HealthFault.ofSession(
            HealthKind.JOURNAL, Priority.CRITICAL, "the journal cannot be written: disk full", "Make room");

    private final ModelWorld world = new ModelWorld();
    private final HealthModel health = world.models.health();

    private Health now() {
        world.settle();
        return health.snapshot();
    }

    @Test
    void aFaultLastsUntilItIsOver() {
        world.nowMillis.set(5_000);
        health.report(FULL);
        world.nowMillis.set(900_000);

        assertThat(now().worst()).contains(new HealthEntry(1, FULL, 5_000));

        health.over(HealthKind.JOURNAL, "");

        assertThat(now().isWell()).isTrue();
    }

    @Test
    void aFaultInOtherWordsIsTheSameFault() {
        world.nowMillis.set(5_000);
        health.report(FULL);
        world.nowMillis.set(6_000);
        HealthFault again = HealthFault.ofSession(HealthKind.JOURNAL, Priority.CRITICAL, "still full", "Make room");
        health.report(again);

        assertThat(now().entries()).containsExactly(new HealthEntry(1, again, 5_000));
    }

    @Test
    void theWorstStandsFirstAndOfEqualOnesTheOldest() {
        HealthFault first = HealthFault.ofBoat(HealthKind.DRIFT, "anna", Priority.HIGH, "anna drifts", "Fetch it");
        HealthFault second = HealthFault.ofBoat(HealthKind.DRIFT, "bert", Priority.HIGH, "bert drifts", "Fetch it");
        health.report(second);
        world.nowMillis.addAndGet(10);
        health.report(first);
        world.nowMillis.addAndGet(10);
        health.report(FULL);

        assertThat(now().entries()).extracting(HealthEntry::fault).containsExactly(FULL, second, first);
        assertThat(now().countFrom(Priority.CRITICAL)).isEqualTo(1);
        assertThat(now().countFrom(Priority.HIGH)).isEqualTo(3);
    }

    @Test
    void anActiveAlarmIsAFaultWithItsAdviceAndAnAlarmThatIsOverIsNone() {
        GeoArea crossed = new GeoArea(
                List.of(GeoPoint.of(0, 0), GeoPoint.of(1, 1), GeoPoint.of(1, 0), GeoPoint.of(0, 1)), List.of());
        world.models.post(
                () -> world.models.alarms().setArea(new OperatingArea(Optional.of(crossed), List.of(), false), 7_000));

        HealthEntry entry = now().worst().orElseThrow();
        assertThat(entry.fault().kind()).isEqualTo(HealthKind.ALARM);
        assertThat(entry.severity()).isEqualTo(Priority.CRITICAL);
        assertThat(entry.fault().advice()).isEqualTo(Alarm.Kind.FENCE.advice());
        assertThat(entry.sinceMillis()).isEqualTo(7_000);

        world.models.post(() -> world.models.alarms().setArea(OperatingArea.OPEN, 8_000));

        assertThat(now().isWell()).isTrue();
        assertThat(world.models.alarms().snapshot())
                .as("it waits to be acknowledged")
                .hasSize(1);
    }

    @Test
    void listenersAreToldOnlyOfWhatChanged() {
        List<Health> told = new ArrayList<>();
        health.addListener(told::add);
        health.report(FULL);
        now();
        health.report(FULL);
        now();

        assertThat(told).hasSize(1);
    }
}
