package org.sami.boat.app.screen;

import static org.assertj.core.api.Assertions.assertThat;

import android.app.Application;
import android.content.ComponentName;
import android.content.Intent;
import android.view.ViewGroup;
import android.widget.Button;
import android.widget.TextView;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
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
import org.robolectric.annotation.Config;
import org.robolectric.shadow.api.Shadow;
import org.robolectric.shadows.ShadowApplication;
import org.robolectric.shadows.ShadowLooper;
import org.sami.boat.app.BoatService;
import org.sami.boat.app.R;
import org.sami.boat.app.boat.BoatOnPhone;
import org.sami.boat.app.boat.LoopbackBoard;
import org.sami.boat.hull.board.BoardState;
import org.sami.boat.server.testing.Await;

/** The guided check of the motors as a person goes through it, with a board on loopback. */
@RunWith(RobolectricTestRunner.class)
@Config(shadows = BoardInUsb.class)
public class MotorCheckActivityTest {
    private final Application phone = RuntimeEnvironment.getApplication();
    private final ServiceController<BoatService> service = Robolectric.buildService(BoatService.class);
    private LoopbackBoard board;
    private BoatService.Link link;
    private ActivityController<MotorCheckActivity> screen;

    @Before
    public void begin() throws IOException {
        board = new LoopbackBoard();
        BoardInUsb.plugIn(board);
        link = (BoatService.Link) service.create().get().onBind(new Intent());
        ShadowApplication app = Shadow.extract(phone);
        app.setComponentNameAndServiceForBindService(new ComponentName(phone, BoatService.class), link);
        untilBoard();
        screen = Robolectric.buildActivity(MotorCheckActivity.class).setup();
        ShadowLooper.idleMainLooper();
    }

    @After
    public void end() {
        screen.close();
        service.destroy();
        board.close();
    }

    private BoatOnPhone boat() {
        return link.boat().orElseThrow();
    }

    private void untilBoard() {
        Await.until("board", () -> {
            ShadowLooper.idleMainLooper(100, TimeUnit.MILLISECONDS);
            return boat().status().board() == BoardState.CONNECTED;
        });
    }

    private String text(int id) {
        return ((TextView) screen.get().findViewById(id)).getText().toString();
    }

    private List<Button> answers() {
        ViewGroup list = screen.get().findViewById(R.id.answers);
        List<Button> all = new ArrayList<>();
        for (int i = 0; i < list.getChildCount(); i++) {
            all.add((Button) list.getChildAt(i));
        }
        return all;
    }

    private void press(String answer) {
        answers().stream()
                .filter(each -> each.getText().toString().equals(answer))
                .findFirst()
                .orElseThrow()
                .performClick();
        ShadowLooper.idleMainLooper();
    }

    /** Drives until the board gets this, and answers. */
    private void driveAndAnswer(String command, String answer) {
        untilBoard();
        screen.get().findViewById(R.id.drive).performClick();
        Await.until(command, () -> board.newest().equals(command));
        press(answer);
    }

    @Test
    public void answersBecomeReversalMostThrustAndTrim() {
        driveAndAnswer("{\"m0\":{\"v\":0.210},\"m1\":{\"v\":0.000}}", "The other way round");
        driveAndAnswer("{\"m0\":{\"v\":0.000},\"m1\":{\"v\":0.210}}", "Yes");
        driveAndAnswer("{\"m0\":{\"v\":-0.300},\"m1\":{\"v\":0.300}}", "Yes");
        assertThat(text(R.id.question)).startsWith("thrust at 40 %");
        driveAndAnswer("{\"m0\":{\"v\":-0.400},\"m1\":{\"v\":0.400}}", "Yes, and that is enough thrust");
        assertThat(text(R.id.wrong)).isEqualTo("the most thrust is 40 % from now on");
        driveAndAnswer("{\"m0\":{\"v\":-0.120},\"m1\":{\"v\":0.120}}", "It turns right");
        driveAndAnswer("{\"m0\":{\"v\":-0.108},\"m1\":{\"v\":0.132}}", "Yes");

        assertThat(text(R.id.question)).isEqualTo("The motors are checked.");
        assertThat(answers()).isEmpty();
        assertThat(boat().board().hull().leftReversed()).isTrue();
        assertThat(boat().board().hull().safeMaximum()).isEqualTo(0.4);
        assertThat(boat().board().hull().trim()).isEqualTo(-0.03);
        assertThat(boat().board().hull().motorsChecked()).isTrue();
    }

    @Test
    public void answersCountOnceTheMotorWasDrivenAndOnlyLaterBeforeIt() {
        assertThat(answers()).hasSize(4).noneMatch(Button::isEnabled);
        driveAndAnswer("{\"m0\":{\"v\":0.210},\"m1\":{\"v\":0.000}}", "Yes");
        driveAndAnswer("{\"m0\":{\"v\":0.000},\"m1\":{\"v\":0.210}}", "Yes");

        assertThat(answers())
                .filteredOn(Button::isEnabled)
                .singleElement()
                .satisfies(later -> assertThat(later.getText().toString()).startsWith("Not now"));
        press("Not now: leave it as it was");
        press("Not now: leave it as it was");
        assertThat(text(R.id.question)).isEqualTo("The motors are checked.");
        assertThat(boat().board().hull().safeMaximum()).isEqualTo(0.7);
    }

    @Test
    public void checkThatIsLeftInTheMiddleLeavesTheSettingsAsTheyWere() {
        driveAndAnswer("{\"m0\":{\"v\":0.210},\"m1\":{\"v\":0.000}}", "The other way round");
        driveAndAnswer("{\"m0\":{\"v\":0.000},\"m1\":{\"v\":0.210}}", "Yes");
        assertThat(boat().board().hull().safeMaximum()).as("what is tried").isEqualTo(0.3);

        screen.pause().stop();

        assertThat(boat().board().hull().leftReversed()).isFalse();
        assertThat(boat().board().hull().safeMaximum()).isEqualTo(0.7);
        screen.start().resume();
    }
}
