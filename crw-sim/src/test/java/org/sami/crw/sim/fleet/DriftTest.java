package org.sami.crw.sim.fleet;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.sami.crw.fleet.publishing.FleetEvents;
import org.sami.crw.operator.OperatorModels;
import org.sami.crw.operator.alarm.Alarm;
import org.sami.crw.operator.alarm.Alarm.Kind;
import org.sami.crw.operator.boat.BoatSnapshot;
import org.sami.crw.operator.health.HealthKind;
import org.sami.crw.operator.map.ShownBoat;
import org.sami.crw.proxy.ProxyRegistry;
import org.sami.crw.proxy.command.KeepStation;
import org.sami.crw.proxy.status.Drift;
import org.sami.crw.sim.clock.VirtualClock;
import org.sami.crw.sim.hull.Conditions;
import org.sami.crw.sim.hull.Flow;
import org.sami.spn.protocol.Priority;
import org.sami.spn.value.GeoPoint;

/** A boat that nobody drives and that current and wind take along: how fast that is said to be, when it is told, and that noise is no drift. */
class DriftTest {
    private final VirtualClock clock = new VirtualClock();
    private final FleetEvents events = new FleetEvents();
    private final ProxyRegistry boats = new ProxyRegistry();
    private final OperatorModels models = new OperatorModels(Runnable::run, clock::nowMs);
    private SimulatedFleet fleet;

    private void sail(int count, long seed, Conditions conditions) {
        fleet = fleet(count, seed, conditions);
        fleet.boats().forEach(boat -> boats.add(boat.proxy()));
        events.subscribe(models.fleetListener(boats));
        fleet.start();
    }

    private SimulatedFleet fleet(int count, long seed, Conditions conditions) {
        return new SimulatedFleet(
                clock, seed, count, 45.4, 10.9, events::found, FleetConfig.DEFAULT.withConditions(conditions));
    }

    private void run(double seconds) {
        for (int i = 0; i < seconds; i++) {
            clock.runUntil(clock.nowMs() + 1000);
            models.look();
        }
    }

    private BoatSnapshot boat() {
        return models.fleet().boat("boat1").orElseThrow();
    }

    private List<Alarm> drifting() {
        return models.alarms().snapshot().stream()
                .filter(alarm -> alarm.kind() == Kind.DRIFT && alarm.active())
                .toList();
    }

    private static Conditions water(double gpsM, double jumpM, String current, String wind) {
        Conditions field = Conditions.FIELD;
        return new Conditions(
                gpsM,
                jumpM,
                field.compassNoiseDeg(),
                Flow.parse(current),
                Flow.parse(wind),
                List.of(),
                field.dischargeIntervalS());
    }

    @Test
    void boatThatNobodyCommandsIsSaidToDriftOnAnOrdinaryDay() {
        sail(1, 1, Conditions.FIELD);
        run(180);

        assertThat(fleet.boats().get(0).hull().eastM()).isBetween(35.0, 50.0);
        assertThat(boat().why().text())
                .matches("boat1 drifts 0\\.2\\d m/s to the east: no mission wants anything of it");
        assertThat(boat().speedMps().orElseThrow()).isBetween(0.2, 0.28);
        ShownBoat shown = models.map().snapshot().boats().get(0);
        assertThat(shown.speedMps()).isEqualTo(boat().speedMps().orElseThrow());
        assertThat(Math.toDegrees(shown.courseRad())).isBetween(75.0, 105.0);
        assertThat(drifting())
                .singleElement()
                .satisfies(alarm -> assertThat(alarm.text())
                        .matches("boat1 drifts 0\\.2\\d m/s to the east: it is \\d+ m from where it was left"));
    }

    @Test
    void driftIsAFaultOfTheSessionFromItsAlarmUntilTheBoatHasACommand() {
        sail(1, 1, Conditions.FIELD);
        run(180);

        assertThat(models.health().snapshot().of(HealthKind.ALARM)).isEmpty();
        assertThat(models.health().snapshot().of(HealthKind.DRIFT))
                .singleElement()
                .satisfies(entry -> {
                    Alarm alarm = drifting().get(0);
                    assertThat(entry.fault().boat()).isEqualTo("boat1");
                    assertThat(entry.fault().text()).isEqualTo(alarm.text());
                    assertThat(entry.fault().advice()).isEqualTo(Kind.DRIFT.advice());
                    assertThat(entry.sinceMillis()).isEqualTo(alarm.sinceMillis());
                });

        GeoPoint here = boat().pose().orElseThrow().position();
        boats.find("boat1")
                .orElseThrow()
                .commands()
                .submit(new KeepStation("m1-a1-boat1", 1, 1, here, 5, Priority.MEDIUM, false));
        run(20);

        assertThat(models.health().snapshot().isWell()).isTrue();
    }

    @ParameterizedTest
    @CsvSource({"1", "2", "3", "4", "5"})
    void driftIsToldWithinTheErrorOfTheReceiver(long seed) {
        sail(1, seed, water(1.4, 2.1, "0.25@200", "0@0"));
        run(240);

        Drift drift = boat().drift().orElseThrow();
        assertThat(drift.speedMps()).isBetween(0.19, 0.31);
        assertThat(Math.toDegrees(drift.courseRad() + 2 * Math.PI) % 360).isBetween(180.0, 220.0);
        assertThat(drift.awayM()).isBetween(52.0, 68.0);
    }

    /** Twenty boats for an hour, looked at every five seconds: a threshold that noise reaches once in a thousand looks would be reached for sure. */
    @Test
    void errorsOfTheReceiverAreNoDrift() {
        fleet = fleet(20, 7, water(1.4, 2.1, "0@0", "0@0"));
        fleet.start();
        for (int i = 0; i < 720; i++) {
            clock.runUntil(clock.nowMs() + 5000);
            assertThat(fleet.boats()).allSatisfy(boat -> {
                Drift drift = boat.proxy().drift().orElseThrow();
                assertThat(drift.isMoving()).isFalse();
                assertThat(drift.awayM()).isLessThan(10);
                assertThat(boat.proxy().explain().text()).contains("does not move");
            });
        }
    }

    @Test
    void boatThatIsCarriedOffItsStationRaisesAnAlarm() {
        sail(1, 3, water(0, 0, "0.3@90", "0@0"));
        run(2);
        GeoPoint here = boat().pose().orElseThrow().position();
        boats.find("boat1")
                .orElseThrow()
                .commands()
                .submit(new KeepStation("m1-a1-boat1", 1, 1, here, 5, Priority.MEDIUM, false));
        run(20);
        assertThat(drifting()).isEmpty();

        fleet.boats().get(0).hull().setBatteryPercent(0);
        run(90);

        assertThat(drifting())
                .singleElement()
                .satisfies(alarm -> assertThat(alarm.text())
                        .matches("boat1 drifts off its station: it is \\d+ m from it and is to keep within 5 m"));
    }

    @Test
    void boatThatDrivesIsNotSaidToDrift() {
        sail(1, 4, Conditions.FIELD);
        run(180);
        assertThat(drifting()).hasSize(1);
        boats.find("boat1")
                .orElseThrow()
                .commands()
                .submit(new KeepStation("m1-a1-boat1", 1, 1, GeoPoint.of(45.4, 10.9), 5, Priority.MEDIUM, false));
        run(10);

        assertThat(boat().drift()).isEmpty();
        assertThat(boat().speedMps())
                .isEqualTo(OptionalDouble.of(boat().pose().orElseThrow().speedMps()));
        assertThat(drifting()).isEmpty();
    }
}
