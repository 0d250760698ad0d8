package org.sami.boat.app.screen;

import android.app.Activity;
import android.app.Application;
import android.content.ComponentName;
import android.content.Intent;
import android.graphics.Bitmap;
import android.graphics.Canvas;
import android.os.SystemClock;
import android.view.View;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.Test;
import org.junit.runner.RunWith;
import org.robolectric.Robolectric;
import org.robolectric.RobolectricTestRunner;
import org.robolectric.RuntimeEnvironment;
import org.robolectric.android.controller.ActivityController;
import org.robolectric.android.controller.ServiceController;
import org.robolectric.annotation.Config;
import org.robolectric.annotation.GraphicsMode;
import org.robolectric.shadow.api.Shadow;
import org.robolectric.shadows.ShadowApplication;
import org.robolectric.shadows.ShadowLooper;
import org.robolectric.shadows.ShadowStatFs;
import org.sami.boat.app.BoatService;
import org.sami.boat.app.R;
import org.sami.boat.app.boat.BoatOnPhone;
import org.sami.boat.hull.position.GpsFix;

/** Draws the screens for docs/boat-app.md: {@code ./gradlew :boat-server-android:app:screenshots}. */
@RunWith(RobolectricTestRunner.class)
@GraphicsMode(GraphicsMode.Mode.NATIVE)
@Config(qualifiers = "w411dp-h823dp-xhdpi")
public class ScreenPictures {
    private final Path folder = Path.of(System.getProperty("pictures"));
    private final Application phone = RuntimeEnvironment.getApplication();
    private final ServiceController<BoatService> service = Robolectric.buildService(BoatService.class);

    private BoatOnPhone begin() {
        ShadowStatFs.registerStats(phone.getFilesDir(), 4_000_000, 2_000_000, 2_000_000);
        BoatService.Link link = (BoatService.Link) service.create().get().onBind(new Intent());
        ShadowApplication app = Shadow.extract(phone);
        app.setComponentNameAndServiceForBindService(new ComponentName(phone, BoatService.class), link);
        BoatOnPhone boat = link.boat().orElseThrow();
        boat.health().setBattery(81, 31);
        return boat;
    }

    private void measure(BoatOnPhone boat) {
        long nowMs = SystemClock.elapsedRealtime();
        boat.position().compass(1.2, nowMs);
        boat.position().gps(new GpsFix(45.61234, 10.65432, 2, 0, Double.NaN), nowMs);
        boat.position().gyro(0, nowMs);
    }

    private void draw(Activity screen, String name) throws IOException {
        ShadowLooper.idleMainLooper();
        View view = screen.getWindow().getDecorView();
        Bitmap picture = Bitmap.createBitmap(view.getWidth(), view.getHeight(), Bitmap.Config.ARGB_8888);
        view.draw(new Canvas(picture));
        try (OutputStream out = Files.newOutputStream(folder.resolve(name + ".png"))) {
            picture.compress(Bitmap.CompressFormat.PNG, 100, out);
        }
    }

    @Test
    public void indoors() throws IOException {
        begin();
        try (ActivityController<BoatActivity> screen = Robolectric.buildActivity(BoatActivity.class)) {
            draw(screen.setup().get(), "app-indoors");
        }
        service.destroy();
    }

    @Test
    @Config(qualifiers = "+night")
    public void dark() throws IOException {
        BoatOnPhone boat = begin();
        measure(boat);
        try (ActivityController<BoatActivity> screen = Robolectric.buildActivity(BoatActivity.class)) {
            screen.setup().get().findViewById(R.id.lock).performLongClick();
            boat.stopNow();
            screen.get().findViewById(R.id.lock).performLongClick();
            draw(screen.get(), "app-stopped-dark");
        }
        service.destroy();
    }

    @Test
    public void outdoors() throws IOException {
        BoatOnPhone boat = begin();
        measure(boat);
        try (ActivityController<BoatActivity> screen = Robolectric.buildActivity(BoatActivity.class)) {
            screen.setup().get().findViewById(R.id.lock).performLongClick();
            draw(screen.get(), "app-unlocked");
        }
        service.destroy();
    }

    @Test
    public void settings() throws IOException {
        begin();
        try (ActivityController<SettingsActivity> screen = Robolectric.buildActivity(SettingsActivity.class)) {
            draw(screen.setup().get(), "app-settings");
        }
        service.destroy();
    }

    @Test
    public void motors() throws IOException {
        begin();
        try (ActivityController<MotorCheckActivity> screen = Robolectric.buildActivity(MotorCheckActivity.class)) {
            draw(screen.setup().get(), "app-motors");
        }
        service.destroy();
    }
}
