package org.sami.boat.hull.board;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.sami.boat.hull.settings.BatteryCurve;
import org.sami.boat.hull.settings.HullKind;
import org.sami.boat.hull.settings.HullSettings;
import org.sami.boat.server.vehicle.Sensor;

class BoardSensorsTest {
    private final BoardSensors sensors = new BoardSensors();

    private String read(String instrument, String channel) {
        Sensor found = sensors.all().stream()
                .filter(one -> one.name().equals(instrument) && one.channel().equals(channel))
                .findFirst()
                .orElseThrow();
        return found.read() + " " + found.unit();
    }

    @Test
    void conductivityAndTemperatureAreChannelsOfOneInstrument() {
        assertThat(sensors.take("es2", "412.5 18.25")).isTrue();

        assertThat(read("es2", "conductivity")).isEqualTo("[412.5] µS/cm");
        assertThat(read("es2", "temperature")).isEqualTo("[18.25] °C");
    }

    @Test
    void oxygenAndAcidityAreRead() {
        sensors.take("atlas_do", "8.31");
        sensors.take("atlas_ph", "7.6");

        assertThat(read("atlas_do", "oxygen")).isEqualTo("[8.31] mg/L");
        assertThat(read("atlas_ph", "ph")).isEqualTo("[7.6] ");
    }

    @Test
    void soundersDepthIsItsThirdValue() {
        assertThat(sensors.take("hds", "$SDDBT,12.3,f,3.75,M,2.0,F")).isTrue();
        assertThat(sensors.take("hds", "$SDMTW,18.5,C")).isTrue();
        assertThat(sensors.take("hds", "$SDRMC,101010,A,,,,,,,,,")).isTrue();

        assertThat(read("hds", "depth")).isEqualTo("[3.75] m");
        assertThat(read("hds", "temperature")).isEqualTo("[18.5] °C");
    }

    @Test
    void sounderWithAWrongChecksumIsRefused() {
        assertThat(sensors.take("hds", "$SDMTW,18.5,C*00")).isFalse();
        assertThat(read("hds", "temperature")).isEqualTo("[] °C");
    }

    @Test
    void eachMeasurementIsReadOnceInItsOrder() {
        sensors.take("winch", "1");
        sensors.take("winch", "2");

        assertThat(read("winch", "depth")).isEqualTo("[1.0] m");
        assertThat(read("winch", "depth")).isEqualTo("[2.0] m");
        assertThat(read("winch", "depth")).isEqualTo("[] m");
    }

    @Test
    void whatNoWaterHasIsRefusedAndTheOtherValueIsKept() {
        assertThat(sensors.take("es2", "NaN 18")).isFalse();
        assertThat(sensors.take("atlas_ph", "99")).isFalse();
        assertThat(sensors.take("atlas_do", "")).isFalse();
        assertThat(sensors.take("laser", "1")).isFalse();

        assertThat(read("es2", "conductivity")).isEqualTo("[] µS/cm");
        assertThat(read("es2", "temperature")).isEqualTo("[18.0] °C");
    }

    @Test
    void conductivityWithoutAThermometerIsRead() {
        assertThat(sensors.take("es2", "412.5")).isTrue();
    }

    @Test
    void thrustDoesNotEmptyTheBattery() {
        BatteryCurve curve = HullSettings.of(HullKind.DIFFERENTIAL).build().battery();
        BatteryGauge gauge = new BatteryGauge();
        assertThat(gauge.percent(curve)).isZero();
        gauge.take(16.4);
        double atRest = gauge.percent(curve);
        for (int second = 0; second < 3; second++) {
            gauge.take(15.2);
        }

        assertThat(gauge.percent(curve)).isGreaterThan(atRest - 10);
        assertThat(gauge.take(Double.NaN)).isFalse();
        assertThat(gauge.take(-1)).isFalse();
    }

    @Test
    void swappedBatteryCountsAfterThreeReports() {
        BatteryCurve curve = HullSettings.of(HullKind.DIFFERENTIAL).build().battery();
        BatteryGauge gauge = new BatteryGauge();
        gauge.take(14.6);
        for (int second = 0; second < 3; second++) {
            gauge.take(16.8);
        }

        assertThat(gauge.percent(curve)).isEqualTo(100);
    }
}
