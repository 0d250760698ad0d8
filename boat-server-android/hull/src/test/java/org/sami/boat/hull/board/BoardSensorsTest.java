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
        assertThat(sensors.take("s1", "es2", "412.5 18.25")).isTrue();

        assertThat(read("es2", "conductivity")).isEqualTo("[412.5] µS/cm");
        assertThat(read("es2", "temperature")).isEqualTo("[18.25] °C");
    }

    @Test
    void oxygenAndAcidityAreRead() {
        sensors.take("s1", "atlas_do", "8.31");
        sensors.take("s1", "atlas_ph", "7.6");

        assertThat(read("atlas_do", "oxygen")).isEqualTo("[8.31] mg/L");
        assertThat(read("atlas_ph", "ph")).isEqualTo("[7.6] ");
    }

    @Test
    void soundersDepthIsItsThirdValue() {
        assertThat(sensors.take("s1", "hds", "$SDDBT,12.3,f,3.75,M,2.0,F")).isTrue();
        assertThat(sensors.take("s1", "hds", "$SDMTW,18.5,C")).isTrue();
        assertThat(sensors.take("s1", "hds", "$SDRMC,101010,A,,,,,,,,,")).isTrue();

        assertThat(read("hds", "depth")).isEqualTo("[3.75] m");
        assertThat(read("hds", "temperature")).isEqualTo("[18.5] °C");
    }

    @Test
    void sounderWithAWrongChecksumIsRefused() {
        assertThat(sensors.take("s1", "hds", "$SDMTW,18.5,C*00")).isFalse();
        assertThat(read("hds", "temperature")).isEqualTo("[] °C");
    }

    @Test
    void eachMeasurementIsReadOnceInItsOrder() {
        sensors.take("s1", "winch", "1");
        sensors.take("s1", "winch", "2");

        assertThat(read("winch", "depth")).isEqualTo("[1.0] m");
        assertThat(read("winch", "depth")).isEqualTo("[2.0] m");
        assertThat(read("winch", "depth")).isEqualTo("[] m");
    }

    @Test
    void whatNoWaterHasIsRefusedAndTheOtherValueIsKept() {
        assertThat(sensors.take("s1", "es2", "NaN 18")).isFalse();
        assertThat(sensors.take("s1", "atlas_ph", "99")).isFalse();
        assertThat(sensors.take("s1", "atlas_do", "")).isFalse();
        assertThat(sensors.take("s1", "laser", "1")).isFalse();

        assertThat(read("es2", "conductivity")).isEqualTo("[] µS/cm");
        assertThat(read("es2", "temperature")).isEqualTo("[18.0] °C");
    }

    @Test
    void twoInstrumentsOfOneTypeAreTwo() {
        sensors.take("s2", "es2", "400 18");
        sensors.take("s3", "es2", "900 19");
        sensors.take("s2", "es2", "401 18");

        assertThat(read("es2", "conductivity")).isEqualTo("[400.0] µS/cm");
        assertThat(read("es2", "conductivity")).isEqualTo("[401.0] µS/cm");
        assertThat(read("es2", "conductivity")).isEqualTo("[] µS/cm");
        assertThat(read("es2 s3", "conductivity")).isEqualTo("[900.0] µS/cm");
        assertThat(read("es2 s3", "temperature")).isEqualTo("[19.0] °C");
    }

    @Test
    void conductivityWithoutAThermometerIsRead() {
        assertThat(sensors.take("s1", "es2", "412.5")).isTrue();
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
