package org.sami.boat.app;

import static org.assertj.core.api.Assertions.assertThat;

import android.app.Notification;
import android.app.Service;
import android.content.Context;
import android.content.Intent;
import android.net.wifi.WifiManager;
import android.os.PowerManager;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.After;
import org.junit.Test;
import org.junit.runner.RunWith;
import org.robolectric.Robolectric;
import org.robolectric.RobolectricTestRunner;
import org.robolectric.RuntimeEnvironment;
import org.robolectric.android.controller.ServiceController;
import org.robolectric.shadow.api.Shadow;
import org.robolectric.shadows.ShadowLooper;
import org.robolectric.shadows.ShadowPowerManager;
import org.robolectric.shadows.ShadowService;
import org.robolectric.shadows.ShadowWifiManager;
import org.sami.boat.app.boat.BoatOnPhone;
import org.sami.boat.app.boat.PhoneStatus;
import org.sami.boat.server.testing.Await;

/** The life of the service. */
@RunWith(RobolectricTestRunner.class)
public class BoatServiceTest {
    private ServiceController<BoatService> controller = Robolectric.buildService(BoatService.class);

    @After
    public void end() {
        controller.destroy();
        Await.until("no thread of the boat", () -> Await.threads("boat-starter") == 0 && Await.threads("USB") == 0);
    }

    private BoatService.Link link() {
        return (BoatService.Link) controller.get().onBind(new Intent());
    }

    private BoatOnPhone boat() {
        return link().boat().orElseThrow();
    }

    private void beginAgain() {
        controller.destroy();
        controller = Robolectric.buildService(BoatService.class).create().startCommand(0, 1);
    }

    @Test
    public void staysInTheForegroundWithProcessorAndWifiAwake() {
        BoatService service = controller.create().startCommand(0, 1).get();

        ShadowService shadow = Shadow.extract(service);
        Notification notification = shadow.getLastForegroundNotification();
        ShadowWifiManager wifi = Shadow.extract((WifiManager) service.getSystemService(Context.WIFI_SERVICE));
        assertThat(notification.extras.getString(Notification.EXTRA_TITLE)).isEqualTo("SAMI boat");
        assertThat(ShadowPowerManager.getLatestWakeLock().isHeld()).isTrue();
        assertThat(wifi.getActiveLockCount()).isEqualTo(1);
    }

    @Test
    public void inDozeAndSwipedAwayItGoesOn() {
        BoatService service = controller.create().startCommand(0, 1).get();
        ShadowPowerManager power = Shadow.extract((PowerManager) service.getSystemService(Context.POWER_SERVICE));
        ShadowService shadow = Shadow.extract(service);

        power.setIsDeviceIdleMode(true);
        service.onTaskRemoved(new Intent());
        ShadowLooper.idleMainLooper();

        assertThat(shadow.isStoppedBySelf()).isFalse();
        assertThat(ShadowPowerManager.getLatestWakeLock().isHeld()).isTrue();
        assertThat(link().boat()).isPresent();
    }

    @Test
    public void begunAgainAfterAKillItIsTheSameBoat() {
        BoatService service = controller.create().get();
        assertThat(service.onStartCommand(null, 0, 1)).isEqualTo(Service.START_STICKY);
        String name = boat().settings().name();
        boat().stopNow();

        beginAgain();

        assertThat(boat().settings().name()).isEqualTo(name);
        assertThat(boat().status().isStopped()).isTrue();
    }

    @Test
    public void damagedFileIsSaidAndTriedAgainUntilItIsMended() throws Exception {
        Path file = RuntimeEnvironment.getApplication().getFilesDir().toPath().resolve("boat.txt");
        Files.write(file, "nonsense".getBytes(StandardCharsets.UTF_8));
        controller.create().startCommand(0, 1);
        assertThat(link().boat()).isEmpty();
        assertThat(link().fault()).contains("boat.txt: expected are the lines name=..., port=... and maybe log=...");

        Files.delete(file);
        ShadowLooper.idleMainLooper(3, java.util.concurrent.TimeUnit.SECONDS);

        assertThat(link().boat()).isPresent();
        assertThat(link().fault()).isEmpty();
    }

    @Test
    public void withoutPermissionsItWaitsForAPositionAndSaysSo() {
        controller.create().startCommand(0, 1);

        assertThat(boat().status().serving()).isEqualTo(PhoneStatus.Serving.WAITS_FOR_POSITION);
        assertThat(boat().status().pose().isLocated()).isFalse();
    }

    @Test
    public void letsThePhoneSleepAfterItsEnd() {
        controller.create().destroy();

        assertThat(ShadowPowerManager.getLatestWakeLock().isHeld()).isFalse();
        controller = Robolectric.buildService(BoatService.class).create();
    }
}
