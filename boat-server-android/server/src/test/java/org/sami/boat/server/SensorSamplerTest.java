package org.sami.boat.server;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Supplier;
import org.junit.jupiter.api.Test;
import org.sami.boat.link.BoatMode;
import org.sami.boat.link.Role;
import org.sami.boat.link.SensorReport;
import org.sami.boat.link.Telemetry;
import org.sami.boat.server.ServerTestBench.Client;
import org.sami.boat.server.vehicle.Sensor;

/** Readings of the instruments on board. */
class SensorSamplerTest {

    private static Sensor sensor(String name, long periodMs, Supplier<List<Double>> values) {
        return new Sensor() {
            @Override
            public String name() {
                return name;
            }

            @Override
            public String channel() {
                return "temperature";
            }

            @Override
            public String unit() {
                return "°C";
            }

            @Override
            public long periodMs() {
                return periodMs;
            }

            @Override
            public List<Double> read() {
                return values.get();
            }
        };
    }

    private static long count(Client client, String sensor) {
        return client.all(SensorReport.class).stream()
                .filter(reading -> reading.sensor().equals(sensor))
                .count();
    }

    @Test
    void readingsWaitWhileTheBoatDoesNotKnowWhereItIs() {
        ServerTestBench bench = new ServerTestBench(sensor("water", 1000, () -> Sensor.single(17)));
        Client client = bench.commander();
        bench.vehicle.eastM = Double.NaN; // the phone has lost its GPS
        bench.run(3, client);
        assertThat(count(client, "water")).isZero();

        bench.vehicle.eastM = 0;
        bench.run(3, client);
        assertThat(count(client, "water")).isEqualTo(3);
    }

    @Test
    void eachSensorReportsAtItsOwnRateToAllWhoSaidHello() {
        ServerTestBench bench = new ServerTestBench(
                sensor("slow", 2000, () -> Sensor.single(17)), sensor("fast", 250, () -> List.of(1.0, 2.0, 3.0)));
        Client commander = bench.commander();
        Client observer = bench.client(Role.OBSERVER, 1);
        Client stranger = bench.new Client();
        bench.run(60, commander, observer);

        for (Client client : List.of(commander, observer)) {
            assertThat(count(client, "slow")).isEqualTo(30);
            assertThat(count(client, "fast")).isBetween(239L, 241L);
        }
        assertThat(stranger.got).isEmpty();
    }

    @Test
    void readingSaysWhereAndWhenItWasTaken() {
        ServerTestBench bench = new ServerTestBench(sensor("ctd", 1000, () -> Sensor.single(17.5)));
        Client client = bench.commander();
        bench.vehicle.northM = 25;
        bench.run(0.1, client);

        SensorReport reading = client.all(SensorReport.class).get(0);
        assertThat(reading.values()).containsExactly(17.5);
        assertThat(reading.unit()).isEqualTo("°C");
        assertThat(reading.latDeg()).isEqualTo(bench.vehicle.latDeg()).isGreaterThan(45);
        assertThat(reading.lonDeg()).isEqualTo(bench.vehicle.lonDeg());
        assertThat(reading.boatTimeMs()).isEqualTo(bench.nowMs);
    }

    @Test
    void sensorWithNothingToSayOrNonsenseReportsNothing() {
        List<List<Double>> answers = new ArrayList<>(
                List.of(List.of(), List.of(Double.NaN), List.of(1.0, Double.NEGATIVE_INFINITY), List.of(4.0)));
        ServerTestBench bench = new ServerTestBench(sensor("ctd", 100, () -> answers.remove(0)));
        Client client = bench.commander();
        bench.run(0.4, client);

        assertThat(client.all(SensorReport.class))
                .extracting(SensorReport::values)
                .containsExactly(List.of(4.0));
    }

    @Test
    void sensorThatFailsIsToldToTheHostAndStopsNothingElse() {
        ServerTestBench bench = new ServerTestBench(
                sensor("broken", 1000, () -> {
                    throw new IllegalStateException("no answer of the probe");
                }),
                sensor("ctd", 1000, () -> Sensor.single(4)));
        Client client = bench.commander();
        assertThatThrownBy(() -> bench.run(0.1, client)).hasMessageContaining("probe");
        bench.run(0.5, client);

        assertThat(count(client, "ctd")).isEqualTo(1);
        assertThat(client.all(Telemetry.class)).isNotEmpty();
        assertThat(bench.server.mode()).isEqualTo(BoatMode.STOPPED);
    }
}
