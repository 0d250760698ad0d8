package org.sami.boat.app.screen;

import static org.assertj.core.api.Assertions.assertThat;

import android.app.Application;
import android.content.ComponentName;
import android.content.Intent;
import android.view.View;
import android.view.ViewGroup;
import android.widget.Button;
import android.widget.EditText;
import android.widget.TextView;
import java.util.ArrayList;
import java.util.List;
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
import org.robolectric.shadows.ShadowApplication;
import org.robolectric.shadows.ShadowLooper;
import org.sami.boat.app.BoatService;
import org.sami.boat.app.R;
import org.sami.boat.app.boat.BoatOnPhone;

/** What a person can press, and what the screens say. */
@RunWith(RobolectricTestRunner.class)
public class BoatActivityTest {
    private final Application phone = RuntimeEnvironment.getApplication();
    private final ServiceController<BoatService> service = Robolectric.buildService(BoatService.class);
    private BoatService.Link link;
    private ActivityController<BoatActivity> screen;

    @Before
    public void begin() {
        link = (BoatService.Link) service.create().get().onBind(new Intent());
        ShadowApplication app = Shadow.extract(phone);
        app.setComponentNameAndServiceForBindService(new ComponentName(phone, BoatService.class), link);
        screen = Robolectric.buildActivity(BoatActivity.class).setup();
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

    private Button button(int id) {
        return screen.get().findViewById(id);
    }

    private List<String> rows() {
        List<String> rows = new ArrayList<>();
        ViewGroup list = screen.get().findViewById(R.id.rows);
        for (int i = 0; i < list.getChildCount(); i++) {
            View row = list.getChildAt(i);
            rows.add(((TextView) row.findViewById(R.id.mark)).getText() + " "
                    + ((TextView) row.findViewById(R.id.label)).getText() + ": "
                    + ((TextView) row.findViewById(R.id.value)).getText());
        }
        return rows;
    }

    private String nextScreen() {
        Intent next = ((ShadowApplication) Shadow.extract(phone)).getNextStartedActivity();
        while (next != null && next.getComponent() == null) { // the system's question about the battery
            next = ((ShadowApplication) Shadow.extract(phone)).getNextStartedActivity();
        }
        return next == null ? "" : next.getComponent().getShortClassName();
    }

    @Test
    public void saysWhatTheBoatLacks() {
        assertThat(((TextView) screen.get().findViewById(R.id.name)).getText().toString())
                .isEqualTo(boat().settings().name());
        assertThat(rows())
                .anyMatch(row -> row.startsWith("✗ GPS: no position"))
                .anyMatch(row -> row.startsWith("✗ Compass: no heading yet"))
                .anyMatch(row -> row.startsWith("✗ Board: "))
                .anyMatch(row -> row.contains("Commander: nobody"));
    }

    @Test
    public void lockedOnlyTheStopWorksAndHasToBeHeld() {
        button(R.id.stop).performClick();
        button(R.id.motors).performClick();
        button(R.id.settings).performClick();
        assertThat(boat().stop().isLatched()).isFalse();
        assertThat(nextScreen()).isEmpty();

        button(R.id.stop).performLongClick();
        assertThat(boat().stop().isLatched()).isTrue();
        button(R.id.stop).performLongClick();
        assertThat(boat().stop().isLatched()).as("not released while locked").isTrue();
        assertThat(button(R.id.stop).getText().toString()).startsWith("STOPPED");
    }

    @Test
    public void unlockedTheStopIsOnePressAndItsReleaseIsHeld() {
        button(R.id.lock).performClick();
        button(R.id.stop).performClick();
        assertThat(boat().stop().isLatched()).as("a press does not unlock").isFalse();

        button(R.id.lock).performLongClick();
        button(R.id.stop).performClick();
        assertThat(boat().stop().isLatched()).isTrue();
        button(R.id.stop).performClick();
        assertThat(boat().stop().isLatched()).isTrue();
        button(R.id.stop).performLongClick();
        assertThat(boat().stop().isLatched()).isFalse();
    }

    @Test
    public void locksItselfWhenNobodyTouchesIt() {
        button(R.id.lock).performLongClick();
        button(R.id.settings).performClick();
        assertThat(nextScreen()).isEqualTo(".screen.SettingsActivity");

        ShadowLooper.idleMainLooper(ScreenLock.AFTER_MS + 1000, java.util.concurrent.TimeUnit.MILLISECONDS);

        assertThat(button(R.id.settings).isEnabled()).isFalse();
    }

    @Test
    public void turnedItShowsTheSameAndIsLocked() {
        button(R.id.lock).performLongClick();
        boat().stopNow();

        screen.recreate();
        ShadowLooper.idleMainLooper();

        assertThat(button(R.id.stop).getText().toString()).isEqualTo("STOPPED\nunlock to release");
        assertThat(boat().stop().isLatched()).isTrue();
    }

    @Test
    public void settingsOutOfTheirLimitsAreRefusedWithTheReasonAndNothingIsKept() {
        try (ActivityController<SettingsActivity> settings = Robolectric.buildActivity(SettingsActivity.class)) {
            settings.setup();
            ShadowLooper.idleMainLooper();
            ((EditText) settings.get().findViewById(R.id.boat_name)).setText("anna");
            ((EditText) settings.get().findViewById(R.id.safe_maximum)).setText("140");
            settings.get().findViewById(R.id.save).performClick();

            String wrong = ((TextView) settings.get().findViewById(R.id.wrong))
                    .getText()
                    .toString();
            assertThat(wrong).contains("safe maximum");
            assertThat(settings.get().isFinishing()).isFalse();
            assertThat(boat().settings().name()).isNotEqualTo("anna");

            ((EditText) settings.get().findViewById(R.id.safe_maximum)).setText("55");
            settings.get().findViewById(R.id.save).performClick();
            assertThat(settings.get().isFinishing()).isTrue();
            assertThat(boat().settings().name()).isEqualTo("anna");
            assertThat(boat().board().hull().safeMaximum()).isEqualTo(0.55);
        }
    }

    @Test
    public void motorsAreNotDrivenWithoutABoard() {
        try (ActivityController<MotorCheckActivity> check = Robolectric.buildActivity(MotorCheckActivity.class)) {
            check.setup();
            ShadowLooper.idleMainLooper();
            assertThat(((TextView) check.get().findViewById(R.id.question))
                            .getText()
                            .toString())
                    .isEqualTo("left motor forward: does it push forward?");

            check.get().findViewById(R.id.drive).performClick();

            assertThat(((TextView) check.get().findViewById(R.id.wrong))
                            .getText()
                            .toString())
                    .startsWith("Nothing is driven");
            assertThat(((ViewGroup) check.get().findViewById(R.id.answers))
                            .getChildAt(0)
                            .isEnabled())
                    .isFalse();
        }
    }
}
