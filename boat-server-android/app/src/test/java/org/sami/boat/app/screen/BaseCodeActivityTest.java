package org.sami.boat.app.screen;

import static org.assertj.core.api.Assertions.assertThat;

import android.app.Activity;
import android.app.Application;
import android.content.ComponentName;
import android.content.Intent;
import android.content.pm.PackageManager;
import android.net.Uri;
import android.view.View;
import android.widget.TextView;
import java.io.IOException;
import java.net.InetAddress;
import java.util.Optional;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
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
import org.robolectric.shadows.ShadowActivity;
import org.robolectric.shadows.ShadowApplication;
import org.robolectric.shadows.ShadowLooper;
import org.sami.boat.app.BoatService;
import org.sami.boat.app.R;
import org.sami.boat.app.boat.BoatOnPhone;
import org.sami.boat.link.Role;
import org.sami.boat.link.security.Fingerprint;
import org.sami.boat.link.security.KeyRing;
import org.sami.boat.link.security.PairingCode;
import org.sami.boat.link.security.PairingSecret;
import org.sami.boat.server.testing.Await;
import org.sami.crw.proxy.phone.PhoneOffer;

/** A phone that is paired by the code of a base, with the base's own part on loopback; without any position. */
@RunWith(RobolectricTestRunner.class)
public class BaseCodeActivityTest {
    private final Application phone = RuntimeEnvironment.getApplication();
    private final ServiceController<BoatService> service = Robolectric.buildService(BoatService.class);
    private final KeyRing baseKeys = KeyRing.inMemory();
    private final BlockingQueue<PhoneOffer.Phone> proved = new LinkedBlockingQueue<>();
    private BoatService.Link link;
    private PhoneOffer offer;
    private Optional<ActivityController<?>> screen = Optional.empty();

    @Before
    public void begin() throws Exception {
        link = (BoatService.Link) service.create().get().onBind(new Intent());
        ShadowApplication app = Shadow.extract(phone);
        app.setComponentNameAndServiceForBindService(new ComponentName(phone, BoatService.class), link);
        offer = new PhoneOffer(
                new PhoneOffer.Setup(InetAddress.getLoopbackAddress(), Optional.empty(), "ann at base", Role.COMMANDER),
                baseKeys,
                () -> 0,
                new PhoneOffer.Listener() {
                    @Override
                    public void proved(PhoneOffer.Phone one) {
                        proved.add(one);
                    }

                    @Override
                    public void refused(String why) {
                        // the phone says it too
                    }
                });
    }

    @After
    public void end() throws IOException {
        screen.ifPresent(ActivityController::close);
        service.destroy();
        offer.close();
    }

    private BoatOnPhone boat() {
        return link.boat().orElseThrow();
    }

    private String code() {
        return offer.code().split("#", 2)[1];
    }

    /** As the page's link gives it to the app. */
    private static Intent linkOf(String code) {
        return new Intent(Intent.ACTION_VIEW, Uri.parse("sami-boat://pair/" + Uri.encode(code)))
                .addCategory(Intent.CATEGORY_BROWSABLE);
    }

    private void open(String code) {
        show(Robolectric.buildActivity(BaseCodeActivity.class, linkOf(code)).setup());
    }

    private void show(ActivityController<?> next) {
        screen.ifPresent(ActivityController::close);
        screen = Optional.of(next);
        ShadowLooper.idleMainLooper();
    }

    private Activity shown() {
        return (Activity) screen.orElseThrow().get();
    }

    private String text(int id) {
        return ((TextView) shown().findViewById(id)).getText().toString();
    }

    private boolean isShown(int id) {
        View view = shown().findViewById(id);
        return view != null && view.isShown();
    }

    private void press(int id) {
        shown().findViewById(id).performClick();
        ShadowLooper.idleMainLooper();
    }

    private void untilSaid(String what) {
        Await.until(what, () -> {
            ShadowLooper.idleMainLooper();
            return text(R.id.wrong).contains(what);
        });
    }

    /** Presses "Yes, pair", and follows to the screen with the check code. */
    private PhoneOffer.Phone pair() throws InterruptedException {
        press(R.id.pair);
        ShadowActivity activity = Shadow.extract(shown());
        Await.until("the base has proved itself", () -> {
            ShadowLooper.idleMainLooper();
            Intent next = activity.peekNextStartedActivity();
            return next != null
                    && PairActivity.class.getName().equals(next.getComponent().getClassName());
        });
        assertThat(shown().isFinishing()).isTrue();
        show(Robolectric.buildActivity(PairActivity.class).setup());
        return proved.poll(60, TimeUnit.SECONDS);
    }

    @Test
    public void linkOfThePageOpensTheAppAndNoOther() {
        assertThat(phone.getPackageManager().queryIntentActivities(linkOf(code()), PackageManager.MATCH_DEFAULT_ONLY))
                .singleElement()
                .satisfies(found -> assertThat(found.activityInfo.name).isEqualTo(BaseCodeActivity.class.getName()));
        assertThat(phone.getPackageManager()
                        .queryIntentActivities(
                                new Intent(Intent.ACTION_VIEW, Uri.parse("http://192.168.43.2/x")),
                                PackageManager.MATCH_DEFAULT_ONLY))
                .isEmpty();
    }

    @Test
    public void baseIsAskedAndKeptOnlyAfterTheCheckCodeWasConfirmed() throws Exception {
        open(code());
        assertThat(text(R.id.state)).startsWith("ann at base at 127.0.0.1:").contains("Is it your own base?");
        assertThat(proved).as("nothing happens without a press").isEmpty();

        PhoneOffer.Phone seen = pair();

        assertThat(text(R.id.check_code)).isEqualTo(seen.checkCode());
        assertThat(seen.boat().fingerprint()).isEqualTo(boat().keys().own());
        assertThat(boat().keys().bases()).as("not before somebody has compared").isEmpty();
        press(R.id.same);
        assertThat(boat().keys().bases()).singleElement().satisfies(base -> {
            assertThat(base.fingerprint()).isEqualTo(baseKeys.identity().fingerprint());
            assertThat(base.role()).isEqualTo(Role.COMMANDER);
        });
        assertThat(text(R.id.wrong)).isEqualTo("ann at base is paired and may command.");
    }

    @Test
    public void otherCheckCodeKeepsNothing() throws Exception {
        open(code());
        pair();

        press(R.id.different);

        assertThat(boat().keys().bases()).isEmpty();
        assertThat(boat().keys().newBase()).isEmpty();
        assertThat(text(R.id.wrong)).startsWith("Another number");
    }

    @Test
    public void baseThatMayOnlyWatchIsAnObserverOnBothSides() throws Exception {
        open(code());
        press(R.id.observer);
        PhoneOffer.Phone seen = pair();
        press(R.id.same);

        assertThat(boat().keys().bases().get(0).role()).isEqualTo(Role.OBSERVER);
        assertThat(seen.boat().role()).isEqualTo(Role.OBSERVER);
    }

    @Test
    public void codeOfAnotherFleetIsNamedAndABaseWithAnotherKeyIsRefused() throws Exception {
        boat().keys().call(PairingCode.parse(code()), Role.COMMANDER);
        boat().keys().confirm();
        assertThat(proved.poll(60, TimeUnit.SECONDS)).isNotNull();
        offer.confirm();
        PairingCode own = PairingCode.parse(code());
        Fingerprint other = KeyRing.inMemory().identity().fingerprint();

        open(new PairingCode(own.address(), "their laptop", other, own.words()).toString());
        assertThat(text(R.id.others)).contains("Paired already: ann at base.", "another fleet");
        press(R.id.pair);

        untilSaid("it is another base, maybe of another fleet");
        assertThat(boat().keys().bases()).hasSize(1);
        assertThat(proved).isEmpty();
    }

    @Test
    public void oldCodeIsRefusedInTheWordsOfTheBase() throws Exception {
        PairingCode now = PairingCode.parse(code());
        open(new PairingCode(now.address(), now.boatName(), now.key(), PairingSecret.random()).toString());
        press(R.id.pair);

        untilSaid("ann at base: the words are not those of the code");
        assertThat(isShown(R.id.pair)).as("it can be tried again").isTrue();
    }

    @Test
    public void baseThatDoesNotAnswerIsSaid() throws Exception {
        String code = code();
        offer.close();
        open(code);
        press(R.id.pair);

        untilSaid("no base answers at 127.0.0.1:");
    }

    @Test
    public void damagedCodeIsSaidAndAsksNothing() {
        open("SAMI1;;damaged");
        assertThat(text(R.id.wrong)).contains("the pairing code is damaged");
        assertThat(isShown(R.id.pair)).isFalse();

        open("https://example.com/");
        assertThat(text(R.id.wrong)).contains("this is no pairing code");
        open("");
        assertThat(isShown(R.id.pair)).isFalse();
    }

    @Test
    public void nextCodeTakesThePlaceOfTheOneThatIsShown() {
        open("nonsense");
        ((BaseCodeActivity) shown()).onNewIntent(linkOf(code()));
        ShadowLooper.idleMainLooper();

        assertThat(text(R.id.wrong)).isEmpty();
        assertThat(isShown(R.id.pair)).isTrue();
    }
}
