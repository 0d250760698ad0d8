package org.sami.boat.app.phone;

import static org.assertj.core.api.Assertions.assertThat;

import android.app.Application;
import android.content.Intent;
import android.os.BatteryManager;
import android.os.SystemClock;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.Predicate;
import org.junit.After;
import org.junit.Before;
import org.junit.Test;
import org.junit.runner.RunWith;
import org.robolectric.RobolectricTestRunner;
import org.robolectric.RuntimeEnvironment;
import org.robolectric.shadows.ShadowLooper;
import org.robolectric.shadows.ShadowStatFs;
import org.sami.boat.app.boat.PhoneHealth;
import org.sami.boat.server.vehicle.Sensor;

/** What the base gets to know of the phone. */
@RunWith(RobolectricTestRunner.class)
public class PhoneWatchTest {
    private final Application phone = RuntimeEnvironment.getApplication();
    private final PhoneHealth health = new PhoneHealth();
    private final AtomicLong dateMs = new AtomicLong(SystemClock.elapsedRealtime()); // 1970
    private final PhoneWatch watch = new PhoneWatch(phone, health, phone.getFilesDir(), dateMs::get);

    @Before
    public void begin() {
        watch.begin();
    }

    @After
    public void end() {
        watch.end();
        ShadowStatFs.unregisterStats(phone.getFilesDir());
    }

    private void send(Intent intent) {
        phone.sendBroadcast(intent);
        ShadowLooper.idleMainLooper();
    }

    private java.util.List<Double> reading(String channel) {
        Predicate<Sensor> named = sensor -> sensor.channel().equals(channel);
        return health.sensors().stream().filter(named).findFirst().orElseThrow().read();
    }

    @Test
    public void weakAndHotPhoneIsTold() {
        assertThat(reading("battery")).as("not known yet").isEmpty();
        send(new Intent(Intent.ACTION_BATTERY_CHANGED)
                .putExtra(BatteryManager.EXTRA_LEVEL, 9)
                .putExtra(BatteryManager.EXTRA_SCALE, 100)
                .putExtra(BatteryManager.EXTRA_TEMPERATURE, 512));

        assertThat(reading("battery")).containsExactly(9.0);
        assertThat(reading("temperature")).containsExactly(51.2);
        assertThat(health.troubles()).contains("phone battery 9 %: charge it", "phone is hot, 51 °C: shade it");
    }

    @Test
    public void fullStorageIsTold() {
        dateMs.set(1_790_000_000_000L);
        ShadowStatFs.registerStats(phone.getFilesDir(), 100_000, 5000, 5000); // blocks of 4096 bytes
        watch.look();

        assertThat(reading("free storage").get(0)).isBetween(20.0, 21.0);
        assertThat(health.troubles()).containsExactly("phone storage is nearly full, 20 MB left: delete something");
    }

    @Test
    public void dateThatIsSetIsToldOnce() {
        dateMs.addAndGet(1_700_000_000_000L);
        send(new Intent(Intent.ACTION_TIME_CHANGED));

        assertThat(reading("date set by").get(0)).isBetween(1_699_999_999.0, 1_700_000_001.0);
        assertThat(reading("date set by")).isEmpty();
    }

    @Test
    public void phoneIn1970IsToldUntilItsDateIsSet() {
        assertThat(reading("date lost")).containsExactly(1.0);
        assertThat(health.troubles()).contains("the phone has lost its date: set it; the boat drives all the same");

        dateMs.set(1_790_000_000_000L);
        watch.look();

        assertThat(reading("date lost")).isEmpty();
    }

    @Test
    public void dateThatOnlyRunsIsNotTold() {
        send(new Intent(Intent.ACTION_TIME_CHANGED));

        assertThat(reading("date set by")).isEmpty();
    }
}
