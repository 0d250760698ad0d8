package org.sami.boat.app.screen;

import android.app.Activity;
import android.os.Bundle;
import android.widget.Button;
import android.widget.CheckBox;
import android.widget.EditText;
import android.widget.RadioButton;
import android.widget.TextView;
import java.io.IOException;
import java.util.Locale;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.sami.boat.app.R;
import org.sami.boat.app.boat.AppFiles;
import org.sami.boat.app.boat.BoatOnPhone;
import org.sami.boat.app.boat.PhoneSettings;
import org.sami.boat.hull.settings.HullKind;
import org.sami.boat.hull.settings.HullSettings;

/** The settings of boat and hull. What is out of its limits is refused with its reason, and nothing is kept of it. */
public final class SettingsActivity extends Activity {
    private static final double PERCENT = 100;

    private final ServiceLink service = new ServiceLink(this, this::show);
    private boolean shown;

    @Override
    protected void onCreate(@Nullable Bundle saved) {
        super.onCreate(saved);
        shown = saved != null; // the fields keep what was typed when the phone is turned
        setContentView(R.layout.settings);
        ((Button) findViewById(R.id.save)).setOnClickListener(view -> save());
    }

    @Override
    protected void onStart() {
        super.onStart();
        service.open();
    }

    @Override
    protected void onStop() {
        service.close();
        super.onStop();
    }

    private void show() {
        Optional<BoatOnPhone> boat = service.boat();
        if (shown || !boat.isPresent()) {
            return;
        }
        shown = true;
        HullSettings hull = boat.get().board().hull();
        field(R.id.boat_name).setText(boat.get().settings().name());
        field(R.id.port).setText(String.valueOf(boat.get().settings().port()));
        ((RadioButton) findViewById(hull.kind() == HullKind.RUDDER ? R.id.rudder : R.id.differential)).setChecked(true);
        field(R.id.safe_maximum).setText(percent(hull.safeMaximum()));
        field(R.id.trim).setText(percent(hull.trim()));
        field(R.id.log_mebibytes).setText(String.valueOf(boat.get().settings().logMebibytes()));
        box(R.id.left_reversed).setChecked(hull.leftReversed());
        box(R.id.right_reversed).setChecked(hull.rightReversed());
        box(R.id.sides_swapped).setChecked(hull.sidesSwapped());
        box(R.id.rudder_reversed).setChecked(hull.rudderReversed());
    }

    private void save() {
        Optional<BoatOnPhone> boat = service.boat();
        if (!boat.isPresent()) {
            return;
        }
        try {
            PhoneSettings named =
                    new PhoneSettings(text(R.id.boat_name), (int) number(R.id.port), (int) number(R.id.log_mebibytes));
            HullSettings hullBefore = boat.get().board().hull();
            HullSettings hull = hull(hullBefore);
            boat.get().setHull(hull);
            boolean other = !named.isSame(boat.get().settings());
            if (other) {
                named.write(new AppFiles(getFilesDir().toPath()));
            }
            if (other || hull.safeMaximum() != hullBefore.safeMaximum()) { // the server reckons with the top speed
                service.beginAnew();
            }
            finish();
        } catch (IllegalArgumentException | IOException e) {
            ((TextView) findViewById(R.id.wrong)).setText(e.getMessage());
        }
    }

    private HullSettings hull(HullSettings before) {
        boolean rudder = ((RadioButton) findViewById(R.id.rudder)).isChecked();
        return before.change()
                .kind(rudder ? HullKind.RUDDER : HullKind.DIFFERENTIAL)
                .safeMaximum(number(R.id.safe_maximum) / PERCENT)
                .trim(number(R.id.trim) / PERCENT)
                .leftReversed(box(R.id.left_reversed).isChecked())
                .rightReversed(box(R.id.right_reversed).isChecked())
                .sidesSwapped(box(R.id.sides_swapped).isChecked())
                .rudderReversed(box(R.id.rudder_reversed).isChecked())
                .build();
    }

    private static String percent(double part) {
        return String.format(Locale.ROOT, "%.0f", part * PERCENT);
    }

    private double number(int id) {
        try {
            return Double.parseDouble(text(id));
        } catch (NumberFormatException e) {
            throw new IllegalArgumentException(getString(R.string.no_number, text(id)), e);
        }
    }

    private String text(int id) {
        return field(id).getText().toString().trim();
    }

    private EditText field(int id) {
        return findViewById(id);
    }

    private CheckBox box(int id) {
        return findViewById(id);
    }
}
