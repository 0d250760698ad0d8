package org.sami.boat.app;

import static org.assertj.core.api.Assertions.assertThat;

import android.app.Notification;
import android.app.Service;
import org.junit.Test;
import org.junit.runner.RunWith;
import org.robolectric.Robolectric;
import org.robolectric.RobolectricTestRunner;
import org.robolectric.android.controller.ServiceController;
import org.robolectric.shadow.api.Shadow;
import org.robolectric.shadows.ShadowPowerManager;
import org.robolectric.shadows.ShadowService;

/** The life of the service. */
@RunWith(RobolectricTestRunner.class)
public class BoatServiceTest {
    private final ServiceController<BoatService> controller = Robolectric.buildService(BoatService.class);

    @Test
    public void staysInTheForegroundAndAwake() {
        BoatService service = controller.create().startCommand(0, 1).get();

        ShadowService shadow = Shadow.extract(service);
        Notification notification = shadow.getLastForegroundNotification();
        assertThat(notification.extras.getString(Notification.EXTRA_TITLE)).isEqualTo("SAMI boat");
        assertThat(ShadowPowerManager.getLatestWakeLock().isHeld()).isTrue();
        controller.destroy();
    }

    @Test
    public void isBegunAgainAfterAKill() {
        BoatService service = controller.create().get();

        assertThat(service.onStartCommand(null, 0, 1)).isEqualTo(Service.START_STICKY);
        controller.destroy();
    }

    @Test
    public void letsThePhoneSleepAfterItsEnd() {
        controller.create().destroy();

        assertThat(ShadowPowerManager.getLatestWakeLock().isHeld()).isFalse();
    }
}
