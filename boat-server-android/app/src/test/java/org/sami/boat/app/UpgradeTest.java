package org.sami.boat.app;

import static org.assertj.core.api.Assertions.assertThat;

import android.app.Application;
import android.content.Intent;
import android.os.SystemClock;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.Arrays;
import java.util.concurrent.TimeUnit;
import org.junit.After;
import org.junit.Before;
import org.junit.Test;
import org.junit.runner.RunWith;
import org.robolectric.Robolectric;
import org.robolectric.RobolectricTestRunner;
import org.robolectric.RuntimeEnvironment;
import org.robolectric.android.controller.ServiceController;
import org.robolectric.shadow.api.Shadow;
import org.robolectric.shadows.ShadowApplication;
import org.robolectric.shadows.ShadowLooper;
import org.sami.boat.app.boat.BoatOnPhone;
import org.sami.boat.app.boat.PairedBase;
import org.sami.boat.app.boat.PhoneStatus;
import org.sami.boat.hull.position.GpsFix;
import org.sami.boat.hull.settings.HullKind;
import org.sami.boat.link.BoatMode;
import org.sami.boat.link.HeldWaypoints;
import org.sami.boat.link.ReadBack;
import org.sami.boat.link.Role;
import org.sami.boat.link.Welcome;
import org.sami.boat.link.security.Identity;
import org.sami.boat.link.security.KeyStoreFolder;
import org.sami.boat.server.testing.Await;

/**
 * An upgrade from the app of 2026-11-26: the files are those that it has written, when a rudder hull named anna was paired with a laptop, had got a list, and was
 * stopped on its screen.
 */
@RunWith(RobolectricTestRunner.class)
public class UpgradeTest {
    private static final String RECORDED = "/version-2026-11-26/";

    private final Application phone = RuntimeEnvironment.getApplication();
    private final Path files = phone.getFilesDir().toPath();
    private final ServiceController<BoatService> service = Robolectric.buildService(BoatService.class);

    @Before
    public void takeOver() throws IOException {
        for (String name : Arrays.asList("boat.txt", "hull.json", "home.txt", "commands.log", "stopped")) {
            copy("phone/" + name, files.resolve(name));
        }
        copy("phone/keys/identity", files.resolve("keys/identity"));
        copy("phone/keys/peers", files.resolve("keys/peers"));
        copy("base/identity", files.resolve("../base/identity"));
    }

    @After
    public void end() {
        service.destroy();
    }

    private static void copy(String name, Path to) throws IOException {
        Files.createDirectories(to.getParent());
        try (InputStream in = UpgradeTest.class.getResourceAsStream(RECORDED + name)) {
            Files.write(to, in.readAllBytes());
        }
        Files.setPosixFilePermissions(to, PosixFilePermissions.fromString("rw-------"));
    }

    private BoatOnPhone upgraded() {
        new StartReceiver().onReceive(phone, new Intent(Intent.ACTION_MY_PACKAGE_REPLACED));
        ShadowApplication app = Shadow.extract(phone);
        assertThat(app.getNextStartedService()).as("it begins without a touch").isNotNull();
        BoatOnPhone boat = ((BoatService.Link)
                        service.create().startCommand(0, 1).get().onBind(new Intent()))
                .boat()
                .orElseThrow();
        Await.until("serves", () -> {
            ShadowLooper.idleMainLooper(100, TimeUnit.MILLISECONDS);
            long nowMs = SystemClock.elapsedRealtime();
            boat.position().gps(new GpsFix(45.6001, 10.6001, 2, 0, Double.NaN), nowMs);
            boat.position().compass(0.5, nowMs);
            return boat.status().serving() == PhoneStatus.Serving.SERVES;
        });
        return boat;
    }

    @Test
    public void keepsIdentityPairingsStopSettingsAndLog() throws Exception {
        Identity laptop = new KeyStoreFolder(files.resolve("../base")).open().identity();

        BoatOnPhone boat = upgraded();

        assertThat(boat.settings().name()).isEqualTo("anna");
        assertThat(boat.settings().port()).isEqualTo(23_411);
        assertThat(boat.keys().own().toString())
                .isEqualTo("c3277fe00182c8761ea821330b793b843c5d2e7be2d93fbd888bf561c312b288");
        assertThat(boat.keys().bases()).singleElement().satisfies(base -> {
            assertThat(base.fingerprint()).isEqualTo(laptop.fingerprint());
            assertThat(base.name()).isEqualTo("laptop");
            assertThat(base.role()).isEqualTo(Role.COMMANDER);
        });
        assertThat(boat.keys().areLinksOpen()).isFalse();
        assertThat(boat.status().isStopped()).as("stopped on its screen").isTrue();
        assertThat(boat.status().mode()).contains(BoatMode.STOPPED);
        assertThat(boat.board().hull().kind()).isEqualTo(HullKind.RUDDER);
        assertThat(boat.board().hull().safeMaximum()).isEqualTo(0.6);
        assertThat(boat.board().hull().trim()).isEqualTo(0.05);

        PairedBase base = new PairedBase(laptop, boat.status().port(), "anna");
        assertThat(base.hello()).as("the laptop reaches it as before").isInstanceOf(Welcome.class);
        assertThat(base.command(new ReadBack("r"), HeldWaypoints.class).listId())
                .as("what its log knows")
                .isEqualTo("list-1");
    }

    @Test
    public void logGoesOnBehindWhatWasThere() throws Exception {
        byte[] before = Files.readAllBytes(files.resolve("commands.log"));

        upgraded();

        assertThat(Files.readAllBytes(files.resolve("commands.log")))
                .hasSizeGreaterThan(before.length)
                .startsWith(before);
    }
}
