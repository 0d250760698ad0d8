package org.sami.boat.app;

import static org.assertj.core.api.Assertions.assertThat;

import android.app.Application;
import android.content.Intent;
import org.junit.Test;
import org.junit.runner.RunWith;
import org.robolectric.RobolectricTestRunner;
import org.robolectric.RuntimeEnvironment;
import org.robolectric.shadow.api.Shadow;
import org.robolectric.shadows.ShadowApplication;
import org.robolectric.shadows.ShadowLooper;

/** What begins the service without a person. */
@RunWith(RobolectricTestRunner.class)
public class StartReceiverTest {
    private final Application phone = RuntimeEnvironment.getApplication();

    @Test
    public void serviceBeginsWhenThePhoneHasStarted() {
        phone.sendBroadcast(new Intent(Intent.ACTION_BOOT_COMPLETED).setPackage(phone.getPackageName()));
        ShadowLooper.idleMainLooper();

        assertThat(shadow().getNextStartedService().getComponent().getClassName())
                .isEqualTo(BoatService.class.getName());
    }

    @Test
    public void serviceBeginsAfterAnUpgrade() {
        new StartReceiver().onReceive(phone, new Intent(Intent.ACTION_MY_PACKAGE_REPLACED));

        assertThat(shadow().getNextStartedService()).isNotNull();
    }

    @Test
    public void otherBroadcastsBeginNothing() {
        new StartReceiver().onReceive(phone, new Intent(Intent.ACTION_SHUTDOWN));

        assertThat(shadow().getNextStartedService()).isNull();
    }

    private ShadowApplication shadow() {
        return Shadow.extract(phone);
    }
}
