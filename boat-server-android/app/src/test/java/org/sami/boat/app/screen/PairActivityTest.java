package org.sami.boat.app.screen;

import static org.assertj.core.api.Assertions.assertThat;

import android.app.AlertDialog;
import android.app.Application;
import android.content.ComponentName;
import android.content.DialogInterface;
import android.content.Intent;
import android.os.SystemClock;
import android.view.View;
import android.view.ViewGroup;
import android.view.WindowManager;
import android.widget.TextView;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import org.junit.After;
import org.junit.Before;
import org.junit.Test;
import org.junit.runner.RunWith;
import org.robolectric.Robolectric;
import org.robolectric.RobolectricTestRunner;
import org.robolectric.RuntimeEnvironment;
import org.robolectric.android.controller.ActivityController;
import org.robolectric.android.controller.ServiceController;
import org.robolectric.shadow.api.Shadow;
import org.robolectric.shadows.ShadowAlertDialog;
import org.robolectric.shadows.ShadowApplication;
import org.robolectric.shadows.ShadowLooper;
import org.sami.boat.app.BoatService;
import org.sami.boat.app.R;
import org.sami.boat.app.boat.BoatOnPhone;
import org.sami.boat.app.boat.PairedBase;
import org.sami.boat.app.boat.PhoneStatus;
import org.sami.boat.hull.position.GpsFix;
import org.sami.boat.link.Goodbye;
import org.sami.boat.link.Welcome;
import org.sami.boat.link.security.PairingSecret;
import org.sami.boat.server.testing.Await;
import org.sami.boat.server.testing.OwnPort;

/** Pairing as a person on board does it, with a base on loopback; TLS is the phone's own, Conscrypt. */
@RunWith(RobolectricTestRunner.class)
public class PairActivityTest {
    private final Application phone = RuntimeEnvironment.getApplication();
    private final ServiceController<BoatService> service = Robolectric.buildService(BoatService.class);
    private BoatService.Link link;
    private ActivityController<PairActivity> screen;

    @Before
    public void begin() throws Exception {
        Files.write(
                phone.getFilesDir().toPath().resolve("boat.txt"),
                ("name=anna\nport=" + OwnPort.draw() + "\n").getBytes(StandardCharsets.UTF_8));
        link = (BoatService.Link) service.create().get().onBind(new Intent());
        ShadowApplication app = Shadow.extract(phone);
        app.setComponentNameAndServiceForBindService(new ComponentName(phone, BoatService.class), link);
        screen = Robolectric.buildActivity(PairActivity.class).setup();
        ShadowLooper.idleMainLooper();
    }

    @After
    public void end() {
        screen.close();
        service.destroy();
    }

    private BoatOnPhone boat() {
        return link.boat().orElseThrow();
    }

    private PairedBase base() {
        Await.until("serves", () -> {
            long nowMs = SystemClock.elapsedRealtime();
            boat().position().gps(new GpsFix(45.6, 10.6, 2, 0, Double.NaN), nowMs);
            boat().position().compass(0.5, nowMs);
            return boat().status().serving() == PhoneStatus.Serving.SERVES;
        });
        return new PairedBase(boat().status().port(), "anna");
    }

    private void press(int id) {
        screen.get().findViewById(id).performClick();
        ShadowLooper.idleMainLooper();
    }

    private String text(int id) {
        return ((TextView) screen.get().findViewById(id)).getText().toString();
    }

    private boolean isShown(int id) {
        return screen.get().findViewById(id).isShown();
    }

    private String bases() {
        StringBuilder all = new StringBuilder();
        ViewGroup list = screen.get().findViewById(R.id.bases);
        for (int i = 0; i < list.getChildCount(); i++) {
            View row = list.getChildAt(i);
            TextView text = row instanceof TextView only ? only : row.findViewById(R.id.base);
            all.append(text.getText()).append('|');
        }
        return all.toString();
    }

    private static void answer(int button) {
        ((AlertDialog) ShadowAlertDialog.getLatestDialog()).getButton(button).performClick();
        ShadowLooper.idleMainLooper();
    }

    private static void passHalfASecond() {
        ShadowLooper.idleMainLooper(600, java.util.concurrent.TimeUnit.MILLISECONDS);
    }

    @Test
    public void pairsABaseWhoseCheckCodeIsConfirmedAndWithdrawsItAgain() throws Exception {
        PairedBase laptop = base();
        assertThat(bases()).isEqualTo("none|");
        assertThat(isShown(R.id.words)).isFalse();
        press(R.id.begin);
        assertThat(isShown(R.id.code)).isTrue();

        laptop.pair(PairingSecret.parse(text(R.id.words)));
        passHalfASecond();
        assertThat(isShown(R.id.words)).isFalse();
        assertThat(text(R.id.check_code))
                .isEqualTo(laptop.checkCode(boat().keys().own()));
        assertThat(text(R.id.state)).isEqualTo("laptop is paired and may command. Does it show this number too?");
        press(R.id.same);

        assertThat(isShown(R.id.check_code)).isFalse();
        assertThat(text(R.id.wrong)).isEqualTo("laptop is paired and may command.");
        assertThat(bases())
                .startsWith("laptop\nmay command\nkey " + laptop.key().shortText());
        assertThat(laptop.hello()).isInstanceOf(Welcome.class);

        press(R.id.withdraw);
        answer(DialogInterface.BUTTON_NEGATIVE);
        assertThat(boat().keys().bases()).hasSize(1);
        press(R.id.withdraw);
        answer(DialogInterface.BUTTON_POSITIVE);
        assertThat(bases()).isEqualTo("none|");
        assertThat(laptop.hello()).isInstanceOf(Goodbye.class);
    }

    @Test
    public void otherCheckCodeWithdrawsTheBase() throws Exception {
        PairedBase laptop = base();
        press(R.id.observer);
        press(R.id.begin);
        laptop.pair(PairingSecret.parse(text(R.id.words)));
        passHalfASecond();
        assertThat(text(R.id.state)).contains("may watch");

        press(R.id.different);

        assertThat(text(R.id.wrong)).startsWith("Another number").contains("laptop is not paired");
        assertThat(boat().keys().bases()).isEmpty();
    }

    @Test
    public void wordsThatNobodyUsedInTimeAreTakenAwayAndSaidToBeOver() {
        press(R.id.begin);
        assertThat(text(R.id.state)).contains("They count once, for ");

        ShadowLooper.idleMainLooper(6, java.util.concurrent.TimeUnit.MINUTES);

        assertThat(isShown(R.id.words)).isFalse();
        assertThat(text(R.id.wrong)).isEqualTo("The words count no longer. Begin anew.");
    }

    @Test
    public void leavingTheScreenEndsThePairingAndTurningThePhoneDoesNot() {
        press(R.id.begin);
        String words = text(R.id.words);
        screen.recreate();
        ShadowLooper.idleMainLooper();
        assertThat(text(R.id.words)).isEqualTo(words);

        screen.pause().stop();

        assertThat(boat().keys().words(boat().nowMs())).isEmpty();
        screen.start().resume();
    }

    @Test
    public void openLinksNeedAConfirmation() {
        press(R.id.open);
        assertThat(boat().keys().areLinksOpen()).isFalse();
        answer(DialogInterface.BUTTON_NEGATIVE);
        assertThat(((android.widget.CheckBox) screen.get().findViewById(R.id.open)).isChecked())
                .isFalse();

        press(R.id.open);
        answer(DialogInterface.BUTTON_POSITIVE);
        assertThat(boat().keys().areLinksOpen()).isTrue();

        press(R.id.open);
        assertThat(boat().keys().areLinksOpen()).as("back needs none").isFalse();
    }

    @Test
    public void otherAppsCannotPhotographTheWords() {
        int flags = screen.get().getWindow().getAttributes().flags;

        assertThat(flags & WindowManager.LayoutParams.FLAG_SECURE).isNotZero();
    }
}
