package org.sami.crw.operator;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.sami.boat.link.PhoneReadings;
import org.sami.crw.fleet.FleetEvent;
import org.sami.crw.operator.alarm.Alarm;
import org.sami.crw.operator.alarm.Alarm.Kind;
import org.sami.crw.operator.health.HealthKind;
import org.sami.crw.proxy.status.BoatReading;
import org.sami.spn.value.GeoPoint;

/** Which alarms follow from what a boat's phone reports of itself. */
class PhoneAlarmTest {
    private static final GeoPoint HERE = GeoPoint.of(45.6, 10.68);

    private final ModelWorld world = new ModelWorld();
    private final OperatorModels models = world.models;

    private void report(String channel, double value) {
        reportOf(PhoneReadings.SENSOR, channel, value);
    }

    private void reportOf(String sensor, String channel, double value) {
        world.events.publish(new FleetEvent.Measured(
                "anna", new BoatReading(sensor, channel, List.of(value), "", HERE, world.nowMillis.get())));
        world.settle();
    }

    private void later(double seconds) {
        world.nowMillis.addAndGet((long) (seconds * 1000));
        models.look();
        world.settle();
    }

    private Optional<Alarm> alarm(Kind kind) {
        return models.alarms().snapshot().stream()
                .filter(alarm -> alarm.kind() == kind)
                .findFirst();
    }

    private boolean isActive(Kind kind) {
        return alarm(kind).filter(Alarm::active).isPresent();
    }

    @Test
    void hotPhoneIsAnAlarmUntilItIsClearlyCooler() {
        report(PhoneReadings.TEMPERATURE, 44.9);
        assertThat(alarm(Kind.PHONE_HOT)).isEmpty();

        report(PhoneReadings.TEMPERATURE, 47.3);
        assertThat(alarm(Kind.PHONE_HOT)).map(Alarm::text).contains("The phone of anna is hot: 47 °C");
        assertThat(models.health().snapshot().of(HealthKind.ALARM))
                .as("the row of faults, which window and console show")
                .anySatisfy(entry -> assertThat(entry.fault().text()).isEqualTo("The phone of anna is hot: 47 °C"));

        report(PhoneReadings.TEMPERATURE, 44);
        assertThat(isActive(Kind.PHONE_HOT)).isTrue();
        report(PhoneReadings.TEMPERATURE, 42.9);
        assertThat(isActive(Kind.PHONE_HOT)).isFalse();
    }

    @Test
    void fullStorageIsAnAlarmUntilThereIsRoom() {
        report(PhoneReadings.FREE_STORAGE, 99);
        assertThat(alarm(Kind.PHONE_STORAGE))
                .map(Alarm::text)
                .contains("The storage of anna's phone is nearly full: 99 MB are left");

        report(PhoneReadings.FREE_STORAGE, 105);
        assertThat(isActive(Kind.PHONE_STORAGE)).isTrue();
        report(PhoneReadings.FREE_STORAGE, 400);
        assertThat(isActive(Kind.PHONE_STORAGE)).isFalse();
    }

    @Test
    void lostDateAndBrokenLogAreAlarmsWhileThePhoneRepeatsThem() {
        report(PhoneReadings.DATE_LOST, 1);
        report(PhoneReadings.LOG_BROKEN, 1);
        later(14);
        report(PhoneReadings.LOG_BROKEN, 1);
        later(2);

        assertThat(isActive(Kind.PHONE_DATE)).isFalse();
        assertThat(isActive(Kind.PHONE_LOG)).isTrue();
        assertThat(alarm(Kind.PHONE_LOG)).map(Alarm::text).get().asString().contains("anna cannot write its log");
    }

    @Test
    void dateThatWasSetIsAnAlarmForAMinute() {
        report(PhoneReadings.DATE_SET_BY, -86_400);
        assertThat(alarm(Kind.PHONE_DATE)).map(Alarm::text).get().asString().contains("1440 min back");

        later(59);
        assertThat(isActive(Kind.PHONE_DATE)).isTrue();
        later(2);
        assertThat(isActive(Kind.PHONE_DATE)).isFalse();
    }

    @Test
    void warmWaterIsNoHotPhone() {
        reportOf("es2", PhoneReadings.TEMPERATURE, 60);

        assertThat(models.alarms().snapshot()).isEmpty();
    }

    @Test
    void boatThatIsGoneTakesItsAlarmsAlong() {
        report(PhoneReadings.TEMPERATURE, 60);
        world.events.publish(new FleetEvent.Removed("anna"));
        world.settle();

        assertThat(isActive(Kind.PHONE_HOT)).isFalse();
        report(PhoneReadings.TEMPERATURE, 44);
        assertThat(isActive(Kind.PHONE_HOT))
                .as("nothing is left of the time before")
                .isFalse();
    }
}
