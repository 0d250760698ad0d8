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
import java.util.concurrent.TimeUnit;
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
import org.sami.boat.app.boat.PairedBase;
import org.sami.boat.app.boat.PhoneStatus;
import org.sami.boat.hull.position.GpsFix;
import org.sami.boat.link.Role;
import org.sami.boat.server.testing.Await;

/** Draws the screens that docs/boat-guide.md shows, and no others: {@code ./gradlew :boat-server-android:app:screenshots}. */
@RunWith(RobolectricTestRunner.class)
@GraphicsMode(GraphicsMode.Mode.NATIVE)
@Config(qualifiers = "w411dp-h823dp-hdpi", shadows = PictureAddress.class)
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

    private <A extends Activity> void screen(Class<A> kind, String name, Steps steps) throws IOException {
        try (ActivityController<A> screen = Robolectric.buildActivity(kind)) {
            A shown = screen.setup().get();
            ShadowLooper.idleMainLooper();
            steps.on(shown);
            ShadowLooper.idleMainLooper(1, TimeUnit.SECONDS);
            draw(shown, name);
        }
        service.destroy();
    }

    /** What is done before the picture is taken. */
    private interface Steps {
        void on(Activity screen) throws IOException;
    }

    private static void unlock(Activity screen) {
        screen.findViewById(R.id.lock).performLongClick();
    }

    private PairedBase paired(BoatOnPhone boat) throws Exception {
        Await.until("serves", () -> {
            measure(boat);
            return boat.status().serving() == PhoneStatus.Serving.SERVES;
        });
        PairedBase base = new PairedBase(boat.status().port(), boat.settings().name());
        boat.keys().beginPairing(Role.COMMANDER, boat.nowMs());
        base.pair(boat.keys().words(boat.nowMs()).orElseThrow());
        return base;
    }

    @Test
    public void indoors() throws IOException {
        begin();
        screen(BoatActivity.class, "app-indoors", screen -> {});
    }

    @Test
    public void unlocked() throws Exception {
        BoatOnPhone boat = begin();
        paired(boat);
        boat.keys().confirm();
        screen(BoatActivity.class, "app-unlocked", ScreenPictures::unlock);
    }

    @Test
    public void motors() throws IOException {
        begin();
        screen(MotorCheckActivity.class, "app-motors", screen -> {});
    }

    @Test
    public void words() throws IOException {
        begin();
        screen(
                PairActivity.class,
                "app-pair-words",
                screen -> screen.findViewById(R.id.begin).performClick());
    }

    @Test
    public void checkCode() throws Exception {
        paired(begin());
        screen(PairActivity.class, "app-pair-check", screen -> {});
    }
}
