package org.sami.crw.sim.run.settings;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.TreeMap;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.sami.crw.fleet.RobotKind;
import org.sami.crw.proxy.tcp.BoatAddress;
import org.sami.crw.service.Geodesy;
import org.sami.crw.sim.hull.Conditions;
import org.sami.crw.sim.hull.Energy;
import org.sami.crw.sim.hull.Flow;
import org.sami.crw.sim.hull.SensorSetting;
import org.sami.spn.value.GeoPoint;

class RunSettingsTest {
    private static final RunSettings FULL = RunSettings.of("visit", "Visit \u00e4", new FleetSettings(5, 30, 612.5, -7))
            .speed(new Speed(2.5))
            .limitMillis(90_500)
            .parameters(Map.of("@x", "a=b", "event.field", "1"))
            .answerAfterMillis(1_500)
            .answers("{\"rules\": []}")
            .interrupts(List.of("recharge:2@10.5", "alarm@7", "alarm@7"))
            .build();

    @Test
    void comesBackFromAJournalsHeader() {
        assertThat(SettingsMap.read(SettingsMap.write(FULL))).isEqualTo(FULL);
    }

    @Test
    void comesBackWithoutALimit() {
        RunSettings unlimited = FULL.withLimit(OptionalLong.empty());

        assertThat(SettingsMap.read(SettingsMap.write(unlimited))).isEqualTo(unlimited);
        assertThat(unlimited.stopMillis()).isEqualTo(RunSettings.LONGEST_MILLIS);
    }

    private static final Conditions ROUGH = new Conditions(
            1.5, 4, Flow.parse("0.3@90"), Flow.parse("5@270"), List.of(SensorSetting.parse("oxygen@0.2")));

    @Test
    void comesBackWithItsWater() {
        RunSettings rough = RunSettings.of("visit", "visit", FULL.fleet().on(ROUGH))
                .answerAfterMillis(0)
                .build();

        assertThat(SettingsMap.read(SettingsMap.write(rough))).isEqualTo(rough);
        assertThat(SettingsMap.write(FULL))
                .doesNotContainKeys("current", "wind", "gpsNoiseM", "compassNoiseDeg", "sensors");
        assertThatThrownBy(() -> rough.connectedTo(BoatAddress.parseAll("quay:5002")))
                .hasMessageContaining("their own water");
    }

    @Test
    void comesBackWithItsPlaceOnEarth() {
        Site site = new Site(Optional.of(GeoPoint.of(-12.25, 0.1 + 0.2)), Optional.of(GeoPoint.of(-12.2501, 0.3)));
        RunSettings there = RunSettings.of("visit", "visit", FULL.fleet().at(site))
                .answerAfterMillis(0)
                .build();

        assertThat(SettingsMap.read(SettingsMap.write(there))).isEqualTo(there);
        assertThat(SettingsMap.write(FULL)).doesNotContainKeys("at", "quay");
        assertThatThrownBy(() -> there.connectedTo(BoatAddress.parseAll("quay:5002")))
                .hasMessageContaining("where they were started");
    }

    @ParameterizedTest
    @ValueSource(strings = {"25.5", "100,0,20,19.9,80"})
    void comesBackWithTheChargesOfItsBatteries(String charges) {
        RunSettings low = RunSettings.of("visit", "visit", FULL.fleet().with(InitialCharges.parse(charges)))
                .answerAfterMillis(0)
                .build();

        assertThat(SettingsMap.read(SettingsMap.write(low))).isEqualTo(low);
        assertThat(SettingsMap.write(FULL)).doesNotContainKey("battery");
        assertThatThrownBy(() -> low.connectedTo(BoatAddress.parseAll("a:1,b:2,c:3,d:4,e:5")))
                .hasMessageContaining("their own batteries");
    }

    @Test
    void comesBackWithTheConsumptionOfItsBoats() {
        RunSettings loaded = RunSettings.of("visit", "visit", FULL.fleet().with(Energy.parse("drag,hotel=12")))
                .build();

        assertThat(SettingsMap.read(SettingsMap.write(loaded))).isEqualTo(loaded);
        assertThat(SettingsMap.write(FULL)).doesNotContainKey("energy");
        assertThatThrownBy(() -> loaded.connectedTo(BoatAddress.parseAll("a:1,b:2,c:3,d:4,e:5")))
                .hasMessageContaining("say what they use themselves");
        assertThatThrownBy(() -> FULL.fleet().withRangeM(1500).with(Energy.parse("0:1,1.5:100")))
                .hasMessageContaining("a range follows from the boats' curve");
    }

    @Test
    void comesBackWithTheRangeOfItsBoats() {
        RunSettings near = RunSettings.of("visit", "visit", FULL.fleet().withRangeM(1500))
                .answerAfterMillis(0)
                .build();

        assertThat(SettingsMap.read(SettingsMap.write(near))).isEqualTo(near);
        assertThat(SettingsMap.write(FULL)).doesNotContainKey("rangeM");
        assertThatThrownBy(() -> near.connectedTo(BoatAddress.parseAll("a:1,b:2,c:3,d:4,e:5")))
                .hasMessageContaining("say their range themselves");
        assertThatThrownBy(() -> FULL.fleet().withRangeM(99)).hasMessageContaining("100 to 1000000 m, not 99.0");
        assertThatThrownBy(() -> FULL.fleet().withRangeM(Double.NaN)).hasMessageContaining("not NaN");
        assertThatThrownBy(() -> FULL.fleet().of(RobotKind.COPTER).withRangeM(1500))
                .hasMessageContaining("copters fly for a time");
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "full", "101", "-1", "NaN", "50,", "50,60"})
    void refusesChargesThatAreNoneOrTooFew(String charges) {
        assertThatThrownBy(() -> FULL.fleet().with(InitialCharges.parse(charges)))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining(", not ");
    }

    @Test
    void comesBackWithTheAddressesOfItsBoats() {
        RunSettings connected = FULL.connectedTo(BoatAddress.parseAll("[::1]:5001,quay:5002"));

        assertThat(SettingsMap.read(SettingsMap.write(connected))).isEqualTo(connected);
        assertThat(connected.fleet().boats()).isEqualTo(2);
        assertThat(connected.isConnected()).isTrue();
        assertThat(FULL.isConnected()).isFalse();
    }

    @Test
    void comesBackWithSimulatedBoatsBesideThoseBehindTcp() {
        FleetSettings three = new FleetSettings(3, 30, 60, 1).at(Site.at(GeoPoint.of(45.7, 10.72)));
        RunSettings mixed = RunSettings.of("visit", "visit", three)
                .speed(Speed.REAL)
                .connect(BoatAddress.parseAll("quay:5002"))
                .build();

        assertThat(mixed.simulatedBesides()).containsExactly("boat1", "boat2");
        assertThat(SettingsMap.read(SettingsMap.write(mixed))).isEqualTo(mixed);
        RunSettings elsewhere = mixed.connectedTo(BoatAddress.parseAll("quay:5003"));
        assertThat(elsewhere.simulatedBesides()).containsExactly("boat1", "boat2");
        assertThat(FULL.simulatedBesides()).isEmpty();
        assertThatThrownBy(() -> mixed.withFleet(mixed.fleet().at(Site.USUAL))).hasMessageContaining("need a place");
    }

    @Test
    void boatsOfThisProcessLieInALineWithTheQuayInTheMiddle() {
        FleetSettings fleet = new FleetSettings(3, 30, 60, 1).at(Site.at(GeoPoint.of(45.7, 10.72)));
        GeoPoint quay = fleet.site().quayInProcess(60);

        List<GeoPoint> berths = fleet.berths(2, 5);

        assertThat(Geodesy.distanceM(quay, GeoPoint.of(45.7, 10.72))).isCloseTo(50, within(0.1));
        assertThat(Geodesy.distanceM(berths.get(0), berths.get(1))).isCloseTo(5, within(0.01));
        assertThat(berths.get(0).lonDeg()).isLessThan(quay.lonDeg());
    }

    @Test
    void boatsBehindTcpHaveNoOtherTimeThanTheRealOne() {
        RunSettings connected = FULL.connectedTo(BoatAddress.parseAll("quay:5002"));

        assertThat(connected.speed()).isEqualTo(Speed.REAL);
        assertThatThrownBy(() -> connected.withSpeed(Speed.MAX)).hasMessageContaining("at speed 1, not max");
    }

    @ParameterizedTest
    @ValueSource(strings = {"plan", "boats", "seed", "speed", "answerAfterMillis", "answers"})
    void namesTheSettingThatIsMissing(String name) {
        Map<String, String> map = new TreeMap<>(SettingsMap.write(FULL));
        map.remove(name);

        assertThatThrownBy(() -> SettingsMap.read(map))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("'" + name + "'");
    }

    @ParameterizedTest
    @CsvSource({"0,12,600", "251,12,600", "3,0,600", "3,10001,600", "3,12,9", "3,12,20001", "3,12,NaN"})
    void refusesNonsense(int boats, int locations, double areaM) {
        assertThatThrownBy(() -> new FleetSettings(boats, locations, areaM, 1))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining(", not ");
    }
}
