package org.sami.boat.app.phone;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import android.Manifest;
import android.app.Application;
import android.content.Context;
import android.content.pm.PackageManager;
import android.hardware.camera2.CameraCharacteristics;
import android.hardware.camera2.CameraManager;
import java.io.IOException;
import java.nio.ByteBuffer;
import org.junit.Before;
import org.junit.Test;
import org.junit.runner.RunWith;
import org.robolectric.RobolectricTestRunner;
import org.robolectric.RuntimeEnvironment;
import org.robolectric.shadow.api.Shadow;
import org.robolectric.shadows.ShadowApplication;
import org.robolectric.shadows.ShadowCameraCharacteristics;
import org.robolectric.shadows.ShadowCameraManager;
import org.robolectric.shadows.ShadowPackageManager;

/** What can be said of the phone's camera without one: pictures themselves only a phone shows. */
@RunWith(RobolectricTestRunner.class)
public class BackCameraTest {
    private static final int MOST = 1000;

    private final Application phone = RuntimeEnvironment.getApplication();
    private final ShadowApplication app = Shadow.extract(phone);
    private final ShadowPackageManager features = Shadow.extract(phone.getPackageManager());
    private final ShadowCameraManager cameras =
            Shadow.extract((CameraManager) phone.getSystemService(Context.CAMERA_SERVICE));
    private final BackCamera camera = new BackCamera(phone);

    @Before
    public void hasACamera() {
        features.setSystemFeature(PackageManager.FEATURE_CAMERA_ANY, true);
        app.denyPermissions(Manifest.permission.CAMERA);
    }

    private void add(String id, int facing) {
        CameraCharacteristics kind = ShadowCameraCharacteristics.newCameraCharacteristics();
        ShadowCameraCharacteristics shadow = Shadow.extract(kind);
        shadow.set(CameraCharacteristics.LENS_FACING, facing);
        cameras.addCamera(id, kind);
    }

    @Test
    public void permissionThatIsDeniedIsSaidAndOneThatIsGivenLaterCounts() {
        assertThat(camera.trouble()).contains("does not let the app use its camera");
        assertThatThrownBy(() -> camera.take(MOST))
                .isInstanceOf(IOException.class)
                .hasMessage(camera.trouble());

        app.grantPermissions(Manifest.permission.CAMERA);

        assertThat(camera.trouble()).isEmpty();
    }

    @Test
    public void phoneWithoutACameraSaysSo() {
        features.setSystemFeature(PackageManager.FEATURE_CAMERA_ANY, false);
        app.grantPermissions(Manifest.permission.CAMERA);

        assertThat(camera.trouble()).isEqualTo("the phone has no camera");
    }

    @Test
    public void cameraThatIsAnnouncedAndNotThereIsAFaultInWords() {
        app.grantPermissions(Manifest.permission.CAMERA);

        assertThatThrownBy(() -> camera.take(MOST))
                .isInstanceOf(IOException.class)
                .hasMessage("the phone has no camera");
    }

    @Test
    public void cameraWithoutJpegIsAFaultInWords() {
        app.grantPermissions(Manifest.permission.CAMERA);
        add("0", CameraCharacteristics.LENS_FACING_FRONT);

        assertThatThrownBy(() -> camera.take(MOST))
                .isInstanceOf(IOException.class)
                .hasMessage("the camera gives no JPEG pictures");
    }

    @Test
    public void pictureOf200MegabytesIsRefusedBeforeItIsCopied() throws Exception {
        ByteBuffer picture = ByteBuffer.allocateDirect(200_000_000);

        assertThatThrownBy(() -> StillPicture.bytes(picture, 8 << 20))
                .isInstanceOf(IOException.class)
                .hasMessage("it has 200000000 bytes, more than 8388608");
        assertThat(StillPicture.bytes(ByteBuffer.wrap(new byte[MOST]), MOST)).hasSize(MOST);
    }
}
