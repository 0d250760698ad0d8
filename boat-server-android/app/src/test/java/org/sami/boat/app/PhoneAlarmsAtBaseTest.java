package org.sami.boat.app;

import static org.assertj.core.api.Assertions.assertThat;

import android.app.Application;
import android.content.Intent;
import android.os.BatteryManager;
import android.os.SystemClock;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.concurrent.TimeUnit;
import org.junit.After;
import org.junit.Before;
import org.junit.Test;
import org.junit.runner.RunWith;
import org.robolectric.Robolectric;
import org.robolectric.RobolectricTestRunner;
import org.robolectric.RuntimeEnvironment;
import org.robolectric.android.controller.ServiceController;
import org.robolectric.shadows.ShadowLooper;
import org.robolectric.shadows.ShadowStatFs;
import org.sami.boat.app.boat.BoatOnPhone;
import org.sami.boat.app.boat.PhoneStatus;
import org.sami.boat.hull.position.GpsFix;
import org.sami.boat.server.testing.Await;
import org.sami.boat.server.testing.OwnPort;
import org.sami.crw.operator.alarm.Alarm;
import org.sami.crw.operator.alarm.Alarm.Kind;
import org.sami.crw.proxy.tcp.BoatAddress;
import org.sami.crw.session.Session;
import org.sami.crw.session.SessionSetup;
import org.sami.spn.json.DomainLibrary;

/** What the phone's own sensors say becomes an alarm at a base: service, link and session are the real ones. */
@RunWith(RobolectricTestRunner.class)
public class PhoneAlarmsAtBaseTest {
    private final Application phone = RuntimeEnvironment.getApplication();
    private final ServiceController<BoatService> service = Robolectric.buildService(BoatService.class);
    private BoatOnPhone boat;
    private Session base;

    @Before
    public void begin() throws Exception {
        Path files = phone.getFilesDir().toPath();
        ShadowStatFs.registerStats(phone.getFilesDir(), 4_000_000, 2_000_000, 2_000_000);
        Files.write(files.resolve("open-links"), new byte[0]);
        Files.write(
                files.resolve("boat.txt"),
                ("name=anna\nport=" + OwnPort.draw() + "\n").getBytes(StandardCharsets.UTF_8));
        boat = ((BoatService.Link) service.create().get().onBind(new Intent()))
                .boat()
                .orElseThrow();
        until("the boat serves", () -> boat.status().serving() == PhoneStatus.Serving.SERVES);
        DomainLibrary library =
                DomainLibrary.fromClassPath("/org/sami/domain/crw").orThrow();
        base = Session.open(
                SessionSetup.of(library.vocabulary(), library.projectOf("clv").orElseThrow()));
        base.begin();
        base.fleet().connect(new BoatAddress("127.0.0.1", boat.status().port()));
        until("the boat is linked", () -> base.models().fleet().boat("anna").isPresent());
    }

    @After
    public void end() throws Exception {
        ShadowStatFs.unregisterStats(phone.getFilesDir());
        if (base != null) {
            base.close();
        }
        service.destroy();
    }

    /** The phone's time goes on, and it knows where it is, until something is so. */
    private void until(String what, java.util.function.BooleanSupplier is) {
        Await.until(what, () -> {
            ShadowLooper.idleMainLooper(200, TimeUnit.MILLISECONDS);
            long nowMs = SystemClock.elapsedRealtime();
            boat.position().gps(new GpsFix(45.6, 10.6, 2, 0, Double.NaN), nowMs);
            boat.position().compass(0.5, nowMs);
            return is.getAsBoolean();
        });
    }

    private boolean isRaised(Kind kind, String text) {
        return base.models().alarms().snapshot().stream()
                .anyMatch(alarm -> alarm.active()
                        && alarm.kind() == kind
                        && alarm.boat().equals("anna")
                        && alarm.text().contains(text));
    }

    private void battery(int percent, int tenthsOfCelsius) {
        phone.sendBroadcast(new Intent(Intent.ACTION_BATTERY_CHANGED)
                .putExtra(BatteryManager.EXTRA_LEVEL, percent)
                .putExtra(BatteryManager.EXTRA_SCALE, 100)
                .putExtra(BatteryManager.EXTRA_TEMPERATURE, tenthsOfCelsius));
    }

    @Test
    public void heatFullStorageAndWeakBatteryOfThePhoneAreAlarmsAtTheBaseUntilTheyAreOver() {
        battery(81, 512);
        until("heat", () -> isRaised(Kind.PHONE_HOT, "The phone of anna is hot: 51 °C"));
        ShadowStatFs.registerStats(phone.getFilesDir(), 100_000, 5000, 5000); // blocks of 4096 bytes
        until("storage", () -> isRaised(Kind.PHONE_STORAGE, "20 MB are left"));

        battery(6, 300);
        until(
                "it has cooled down",
                () -> base.models().alarms().snapshot().stream()
                        .filter(alarm -> alarm.kind() == Kind.PHONE_HOT)
                        .noneMatch(Alarm::active));
        until("weak battery", () -> isRaised(Kind.BATTERY_CRITICAL, "anna"));
        assertThat(isRaised(Kind.PHONE_STORAGE, "20 MB")).isTrue();
    }

    @Test
    public void dateOf1970IsAnAlarmAndTheBoatServesAllTheSame() {
        // the clock of this machine is not in 1970: the loss is reported to the watch as PhoneWatch would do
        until("date", () -> {
            boat.health().setDateLost(true);
            return isRaised(Kind.PHONE_DATE, "has lost its date");
        });

        boat.health().clockSet(1.7e9);
        until("date set", () -> isRaised(Kind.PHONE_DATE, "days forward"));
        assertThat(boat.status().serving()).isEqualTo(PhoneStatus.Serving.SERVES);
    }
}
