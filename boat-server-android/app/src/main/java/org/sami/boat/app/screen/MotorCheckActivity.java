package org.sami.boat.app.screen;

import android.app.Activity;
import android.os.Bundle;
import android.view.LayoutInflater;
import android.view.ViewGroup;
import android.widget.Button;
import android.widget.TextView;
import java.io.IOException;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.sami.boat.app.R;
import org.sami.boat.app.boat.BoatOnPhone;
import org.sami.boat.hull.settings.HullSettings;
import org.sami.boat.hull.settings.MotorAnswer;
import org.sami.boat.hull.settings.MotorCheck;
import org.sami.boat.hull.settings.MotorStep;

/** The guided check of the motors: drives one, asks what was seen, and sets the hull accordingly. */
public final class MotorCheckActivity extends Activity {
    private final ServiceLink service = new ServiceLink(this, this::begin);
    private Optional<MotorCheck> check = Optional.empty();
    private Optional<HullSettings> before = Optional.empty();
    private boolean driven;

    @Override
    protected void onCreate(@Nullable Bundle saved) {
        super.onCreate(saved);
        setContentView(R.layout.motors);
        button(R.id.drive).setOnClickListener(view -> drive());
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
            driven = false;
            check = Optional.of(new MotorCheck(boat.board().hull(), boat::drive));
            show("");
        });
    }

    private void drive() {
        if (check.isPresent()) {
            boolean drives = check.get().drive();
            driven = drives;
            show(drives ? "" : getString(R.string.cannot_drive));
        }
    }

    private void answer(MotorAnswer answer) {
        Optional<BoatOnPhone> boat = service.boat();
        if (!boat.isPresent() || !check.isPresent()) {
            return;
        }
        check.get().answer(answer);
        driven = false;
        String trouble = check.get().trouble();
        try {
            if (check.get().step().isPresent()) {
                boat.get().board().setHull(check.get().settings()); // so that a swap can be seen, and thrust be tried
            } else {
                keep(boat.get(), check.get().settings());
            }
        } catch (IOException e) {
            trouble = String.valueOf(e.getMessage());
        }
        show(trouble);
    }

    private void keep(BoatOnPhone boat, HullSettings found) throws IOException {
        boat.setHull(found);
        if (before.isPresent() && before.get().safeMaximum() != found.safeMaximum()) {
            service.beginAnew(); // the server reckons with the top speed
        }
    }

    private void show(String trouble) {
        Optional<MotorStep> step = check.flatMap(MotorCheck::step);
        ((TextView) findViewById(R.id.question))
                .setText(step.isPresent() ? check.get().question() : getString(R.string.motors_checked));
        ((TextView) findViewById(R.id.wrong)).setText(trouble);
        button(R.id.drive).setEnabled(step.isPresent());
        showAnswers(step.map(MotorStep::answers).orElse(Collections.emptyList()));
    }

    /** Answers that the step takes; but that it is left, they count once it was driven. */
    private void showAnswers(List<MotorAnswer> taken) {
        ViewGroup list = findViewById(R.id.answers);
        list.removeAllViews();
        for (MotorAnswer answer : taken) {
            Button button = (Button) LayoutInflater.from(this).inflate(R.layout.answer, list, false);
            button.setText(words(answer));
            button.setTag(answer);
            button.setEnabled(driven || answer == MotorAnswer.LATER);
            button.setOnClickListener(view -> answer(answer));
            list.addView(button);
        }
    }

    private static int words(MotorAnswer answer) {
        switch (answer) {
            case YES:
                return R.string.yes;
            case REVERSED:
                return R.string.reversed;
            case OTHER_SIDE:
                return R.string.other_side;
            case NOTHING:
                return R.string.nothing;
            case FALTERED:
                return R.string.faltered;
            case ENOUGH:
                return R.string.enough;
            case PULLS_LEFT:
                return R.string.pulls_left;
            case PULLS_RIGHT:
                return R.string.pulls_right;
            default:
                return R.string.later;
        }
    }

    private Button button(int id) {
        return findViewById(id);
    }
}
