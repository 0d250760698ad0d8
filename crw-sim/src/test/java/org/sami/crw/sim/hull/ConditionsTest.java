package org.sami.crw.sim.hull;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import java.util.TreeSet;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.sami.boat.server.vehicle.LocalFrame;
import org.sami.boat.server.vehicle.Sensor;
import org.sami.crw.service.water.CrossTrackError;

class ConditionsTest {
    private static final LocalFrame FRAME = new LocalFrame(45.4, 10.9);

    private static Conditions flowing(String current, String wind) {
        return new Conditions(0, 0, Flow.parse(current), Flow.parse(wind), List.of());
    }

    private static SimulatedHull hull(Conditions conditions, long seed) {
        return new SimulatedHull(HullConfig.DEFAULT, conditions, FRAME, 0, 0, seed);
    }

    private static void step(SimulatedHull hull, double seconds) {
        for (int i = 0; i < Math.round(seconds * 10); i++) {
            hull.step(0.1);
        }
    }

    @Test
    void currentCarriesAHullThatRestsWhereItFlowsTo() {
        SimulatedHull hull = hull(flowing("0.3@90", "0@0"), 1);
        step(hull, 100);

        assertThat(hull.eastM()).isCloseTo(30, within(1e-9));
        assertThat(hull.northM()).isCloseTo(0, within(1e-9));
        assertThat(hull.distanceM()).isZero();
        assertThat(hull.batteryPercent()).isEqualTo(100);
        assertThat(hull.speedMps()).as("its bow points to the north").isCloseTo(0, within(1e-9));
    }

    @Test
    void speedOverGroundIsThatThroughTheWaterAndTheCurrentsPart() {
        SimulatedHull hull = hull(flowing("0.5@180", "0@0"), 1);
        hull.setMotors(0.5, 0.5);
        step(hull, 20);

        assertThat(hull.speedMps()).isCloseTo(1.6 - 0.5, within(1e-9));
    }

    @Test
    void windBlowsAHullAwayFromWhereItComesInGusts() {
        SimulatedHull hull = hull(flowing("0@0", "5@270"), 1);
        TreeSet<Double> speeds = new TreeSet<>();
        for (int i = 0; i < 600; i++) {
            double before = hull.eastM();
            step(hull, 1);
            speeds.add(hull.eastM() - before);
        }

        assertThat(hull.eastM() / 600).isCloseTo(5 * Weather.LEEWAY, within(0.03));
        assertThat(Math.abs(hull.northM())).isLessThan(1e-6);
        assertThat(speeds.last()).isGreaterThan(1.3 * speeds.first());
        assertThat(speeds.first()).isNotNegative();
    }

    @Test
    void equalSeedsGiveEqualGustsAndOtherSeedsOthers() {
        Conditions windy = flowing("0.1@10", "8@200");
        SimulatedHull one = hull(windy, 5);
        SimulatedHull same = hull(windy, 5);
        SimulatedHull other = hull(windy, 6);
        step(one, 300);
        step(same, 300);
        step(other, 300);

        assertThat(same.eastM()).isEqualTo(one.eastM());
        assertThat(same.northM()).isEqualTo(one.northM());
        assertThat(other.northM()).isNotEqualTo(one.northM());
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.1, 1})
    void errorsOfInstrumentsWanderWithTheirDeviationWhateverTheStep(double seconds) {
        SimulatedHull hull = hull(Conditions.CALM, 1);
        Instruments instruments = new Instruments(hull, new Conditions(2, 5, Flow.NONE, Flow.NONE, List.of()), 3, 1);
        double squaresM = 0;
        double squaresDeg = 0;
        double largestJumpM = 0;
        double before = Double.NaN;
        int count = (int) (20_000 / seconds);
        for (int i = 0; i < count; i++) {
            instruments.step(seconds);
            double northM = FRAME.northM(instruments.latDeg(), instruments.lonDeg());
            squaresM += northM * northM;
            squaresDeg += Math.pow(Math.toDegrees(instruments.headingRad()), 2);
            largestJumpM = Double.isNaN(before) ? 0 : Math.max(largestJumpM, Math.abs(northM - before));
            before = northM;
        }

        assertThat(Math.sqrt(squaresM / count)).isCloseTo(2, within(0.3));
        assertThat(Math.sqrt(squaresDeg / count)).isCloseTo(5, within(0.5));
        assertThat(largestJumpM).as("no jumps").isLessThan(6 * 2 * Math.sqrt(2 * seconds / 20));
        assertThat(hull.northM()).as("the truth stays").isZero();
        assertThat(instruments.speedMps()).isZero();
    }

    @Test
    void positionsJumpNowAndThenAndComeBack() {
        SimulatedHull hull = hull(Conditions.CALM, 1);
        Conditions jumping =
                new Conditions(0, 2.1, 0, Flow.NONE, Flow.NONE, List.of(), Conditions.USUAL_DISCHARGE_INTERVAL_S);
        Instruments instruments = new Instruments(hull, jumping, 3, 1);
        int jumps = 0;
        double farthestM = 0;
        double beforeM = 0;
        for (int i = 0; i < 100_000; i++) {
            instruments.step(0.1);
            double offM = FRAME.distanceM(instruments.latDeg(), instruments.lonDeg());
            jumps += offM > beforeM + 0.3 ? 1 : 0;
            farthestM = Math.max(farthestM, offM);
            beforeM = offM;
        }

        assertThat(jumps).as("in 10,000 s").isBetween(150, 330);
        assertThat(farthestM).isBetween(1.9, 2.1);
        assertThat(hull.northM()).as("the truth stays").isZero();
    }

    @Test
    void conditionsHaveNames() {
        assertThat(Conditions.FIELD.toMap())
                .containsEntry("gpsNoiseM", "1.4")
                .containsEntry("gpsJumpM", "2.1")
                .containsEntry("compassNoiseDeg", "4.0");
        assertThat(Conditions.fromMap(Conditions.FIELD.toMap())).isEqualTo(Conditions.FIELD);
        assertThat(Conditions.fromMap(Conditions.ROUGH.toMap())).isEqualTo(Conditions.ROUGH);
    }

    @Test
    void exactInstrumentsKnowTheTruthToTheLastBit() {
        SimulatedHull hull = hull(Conditions.CALM, 1);
        Instruments instruments = new Instruments(hull, Conditions.CALM, 3, 1);
        instruments.setMotors(1, 0.3);
        for (int i = 0; i < 500; i++) {
            hull.step(0.1);
            instruments.step(0.1);

            assertThat(instruments.latDeg()).isEqualTo(hull.latDeg());
            assertThat(instruments.lonDeg()).isEqualTo(hull.lonDeg());
            assertThat(instruments.headingRad()).isEqualTo(hull.headingRad());
        }
        assertThat(instruments.sensors()).isEmpty();
    }

    @Test
    void fieldIsSmoothVariesOverAnAreaAndIsTheSameForEverybodyOfOneSeed() {
        SplittableRandom random = new SplittableRandom(9);
        for (SensorKind kind : SensorKind.values()) {
            ScalarField field = new ScalarField(kind, 7);
            TreeSet<Double> values = new TreeSet<>();
            for (int i = 0; i < 500; i++) {
                double latDeg = 45.4 + random.nextDouble(-0.005, 0.005);
                double lonDeg = 10.9 + random.nextDouble(-0.005, 0.005);
                double value = field.at(latDeg, lonDeg);
                values.add(value);
                double metreAway = field.at(latDeg + 9e-6, lonDeg);
                assertThat(metreAway).isCloseTo(value, within(0.02 * kind.spread()));
                assertThat(new ScalarField(kind, 7).at(latDeg, lonDeg)).isEqualTo(value);
            }
            assertThat(values.last() - values.first()).as("%s", kind).isGreaterThan(0.4 * kind.spread());
            assertThat(values.first()).isGreaterThan(kind.mean() - 2.5 * kind.spread());
            assertThat(values.last()).isLessThan(kind.mean() + 2.5 * kind.spread());
            assertThat(new ScalarField(kind, 8).at(45.4, 10.9)).isNotEqualTo(field.at(45.4, 10.9));
        }
    }

    @Test
    void fieldHasNoStepWhereItsCellsMeet() {
        ScalarField field = new ScalarField(SensorKind.TEMPERATURE, 7);
        for (int i = 0; i < 200; i++) {
            double border = 0.002 * (22_700 + i);
            assertThat(field.at(border - 1e-9, 10.9)).isCloseTo(field.at(border + 1e-9, 10.9), within(1e-3));
            assertThat(field.at(45.4, border - 1e-9)).isCloseTo(field.at(45.4, border + 1e-9), within(1e-3));
        }
    }

    @Test
    void sensorsMeasureTheFieldWhereTheHullTrulyIs() {
        Conditions conditions = new Conditions(
                50,
                0,
                Flow.NONE,
                Flow.NONE,
                List.of(SensorSetting.parse("temperature"), SensorSetting.parse("ph@0.5")));
        SimulatedHull hull = hull(conditions, 1);
        Instruments instruments = new Instruments(hull, conditions, 3, 77);
        Sensor temperature = instruments.sensors().get(0);
        double sum = 0;
        for (int i = 0; i < 500; i++) {
            sum += temperature.read().get(0);
        }

        assertThat(sum / 500).isCloseTo(new ScalarField(SensorKind.TEMPERATURE, 77).at(45.4, 10.9), within(0.02));
        assertThat(temperature.unit()).isEqualTo("°C");
        assertThat(temperature.periodMs()).isEqualTo(1000);
        assertThat(instruments.sensors().get(1).channel()).isEqualTo("ph");
        assertThat(instruments.sensors().get(1).periodMs()).isEqualTo(2000);
    }

    @Test
    void textGivesBackTheConditionsAndCalmWaterNeedsNone() {
        Conditions rough = new Conditions(
                1.5, 4, Flow.parse("0.3@90"), Flow.parse("5@270"), List.of(SensorSetting.parse("oxygen@0.2")), 60);

        assertThat(Conditions.fromMap(rough.toMap())).isEqualTo(rough);
        assertThat(Conditions.CALM.toMap()).isEmpty();
        assertThat(Conditions.fromMap(Conditions.CALM.toMap())).isEqualTo(Conditions.CALM);
    }

    @Test
    void refusesNonsenseAndSaysWhatIsExpected() {
        assertThatThrownBy(() -> Flow.parse("0.3")).hasMessageContaining("0.3@90");
        assertThatThrownBy(() -> Flow.parse("fast@north")).hasMessageContaining("fast@north");
        assertThatThrownBy(() -> Flow.parse("NaN@0")).hasMessageContaining("NaN@0");
        assertThatThrownBy(() -> Flow.parse("51@0")).hasMessageContaining("0 to 50");
        assertThatThrownBy(() -> Flow.parse("1@361")).hasMessageContaining("360");
        assertThatThrownBy(() -> SensorSetting.parse("salt")).hasMessageContaining("temperature, conductivity");
        assertThatThrownBy(() -> SensorSetting.parse("ph@often")).hasMessageContaining("ph@often");
        assertThatThrownBy(() -> SensorSetting.parse("ph@11")).hasMessageContaining("11");
        assertThatThrownBy(() -> new Conditions(-1, 0, Flow.NONE, Flow.NONE, List.of()))
                .hasMessageContaining("GPS");
        assertThatThrownBy(() -> new Conditions(0, 0, Flow.NONE, Flow.NONE, List.of(), -1))
                .hasMessageContaining("discharge interval");
        SensorSetting twice = SensorSetting.parse("ph");
        assertThatThrownBy(() -> new Conditions(0, 0, Flow.NONE, Flow.NONE, List.of(twice, twice)))
                .hasMessageContaining("once");
    }

    @Test
    void boatsThatSayNothingAreTakenToBeAsInTheField() {
        assertThat(CrossTrackError.FIELD).isEqualTo(Conditions.FIELD.crossTrackError());
        assertThat(NamedConditions.of(Map.of())).isEqualTo(NamedConditions.FIELD);
        for (NamedConditions one : NamedConditions.values()) {
            assertThat(NamedConditions.of(one.settings())).isEqualTo(one);
            assertThat(one.services().error()).isEqualTo(one.conditions().crossTrackError());
        }
    }
}
