package org.sami.boat.app.screen;

import android.app.Activity;
import android.os.Bundle;
import android.view.View;
import android.widget.Button;
import android.widget.TextView;
import java.io.IOException;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.sami.boat.app.R;
import org.sami.boat.app.boat.BoatOnPhone;
import org.sami.boat.hull.settings.HullKind;
import org.sami.boat.hull.settings.HullSettings;
import org.sami.boat.hull.settings.MotorCheck;

/** The guided check of the motors: drives one, asks what was seen, and sets the hull accordingly. */
public final class MotorCheckActivity extends Activity {
    private final ServiceLink service = new ServiceLink(this, this::begin);
    private Optional<MotorCheck> check = Optional.empty();
    private Optional<HullSettings> before = Optional.empty();

    @Override
    protected void onCreate(@Nullable Bundle saved) {
        super.onCreate(saved);
        setContentView(R.layout.motors);
        button(R.id.drive).setOnClickListener(view -> drive());
        answers(R.id.yes, MotorCheck.Answer.YES);
        answers(R.id.reversed, MotorCheck.Answer.REVERSED);
        answers(R.id.other_side, MotorCheck.Answer.OTHER_SIDE);
        answers(R.id.nothing, MotorCheck.Answer.NOTHING);
    }

    private void answers(int id, MotorCheck.Answer answer) {
        button(id).setOnClickListener(view -> answer(answer));
    }

    @Override
    protected void onStart() {
        super.onStart();
        service.open();
    }

    /** A check that was left in the middle changes nothing. */
    @Override
    protected void onStop() {
        service.boat().ifPresent(boat -> {
            boat.drive(0, 0, 0);
            boolean over = check.isPresent() && !check.get().step().isPresent();
            if (!over) {
                before.ifPresent(boat.board()::setHull);
            }
        });
        check = Optional.empty();
        service.close();
        super.onStop();
    }

    private void begin() {
        service.boat().ifPresent(boat -> {
            before = Optional.of(boat.board().hull());
            check = Optional.of(new MotorCheck(boat.board().hull(), boat::drive));
            show("");
        });
    }

    private void drive() {
        if (check.isPresent()) {
            boolean drives = check.get().drive();
            showAnswers(drives);
            show(drives ? "" : getString(R.string.cannot_drive));
        }
    }

    private void answer(MotorCheck.Answer answer) {
        Optional<BoatOnPhone> boat = service.boat();
        if (!boat.isPresent() || !check.isPresent()) {
            return;
        }
        check.get().answer(answer);
        showAnswers(false);
        String trouble = check.get().trouble();
        try {
            if (check.get().step().isPresent()) {
                boat.get().board().setHull(check.get().settings()); // so that a swap can be seen
            } else {
                boat.get().setHull(check.get().settings());
            }
        } catch (IOException e) {
            trouble = String.valueOf(e.getMessage());
        }
        show(trouble);
    }

    private void show(String trouble) {
        Optional<MotorCheck.Step> step = check.flatMap(MotorCheck::step);
        ((TextView) findViewById(R.id.question))
                .setText(step.map(MotorCheck.Step::question).orElse(getString(R.string.motors_checked)));
        ((TextView) findViewById(R.id.wrong)).setText(trouble);
        button(R.id.drive).setEnabled(step.isPresent());
    }

    private void showAnswers(boolean driven) {
        int[] all = {R.id.yes, R.id.reversed, R.id.other_side, R.id.nothing};
        for (int id : all) {
            button(id).setEnabled(driven);
        }
        boolean oneMotor = before.isPresent() && before.get().kind() == HullKind.RUDDER;
        button(R.id.other_side).setVisibility(oneMotor ? View.GONE : View.VISIBLE);
    }

    private Button button(int id) {
        return findViewById(id);
    }
}
