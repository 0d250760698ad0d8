package org.sami.boat.app.screen;

import android.Manifest;
import android.app.Activity;
import android.content.Intent;
import android.content.pm.PackageManager;
import android.net.Uri;
import android.os.Build;
import android.os.Bundle;
import android.os.Handler;
import android.os.Looper;
import android.os.PowerManager;
import android.os.SystemClock;
import android.provider.Settings;
import android.view.LayoutInflater;
import android.view.View;
import android.view.ViewGroup;
import android.widget.Button;
import android.widget.TextView;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.sami.boat.app.R;
import org.sami.boat.app.boat.BoatOnPhone;
import org.sami.boat.app.boat.PhoneStatus;

/** The first screen: how the boat is, and the stop. */
public final class BoatActivity extends Activity {
    private static final long PERIOD_MS = 500;
    private static final int ASKED = 1;
    private static final String BACKGROUND_LOCATION = "android.permission.ACCESS_BACKGROUND_LOCATION"; // from API 29 on

    private final Handler main = new Handler(Looper.getMainLooper());
    private final Runnable looks = this::look;
    private final ServiceLink service = new ServiceLink(this, this::show);
    private final ScreenLock lock = new ScreenLock();
    private StatusRows rows;

    @Override
    protected void onCreate(@Nullable Bundle saved) {
        super.onCreate(saved);
        setContentView(R.layout.boat);
        rows = new StatusRows(getResources());
        button(R.id.stop).setOnClickListener(view -> stopPressed(false));
        button(R.id.stop).setOnLongClickListener(view -> stopPressed(true));
        button(R.id.lock).setOnClickListener(view -> lockNow());
        button(R.id.lock).setOnLongClickListener(view -> unlock());
        button(R.id.motors).setOnClickListener(view -> open(MotorCheckActivity.class));
        button(R.id.pair).setOnClickListener(view -> open(PairActivity.class));
        button(R.id.settings).setOnClickListener(view -> open(SettingsActivity.class));
        askOnce();
    }

    /** Asks for what the boat needs; without it the boat goes on, and the screen says what it lacks. */
    private void askOnce() {
        List<String> wanted = new ArrayList<>();
        if (checkSelfPermission(Manifest.permission.ACCESS_FINE_LOCATION) != PackageManager.PERMISSION_GRANTED) {
            wanted.add(Manifest.permission.ACCESS_FINE_LOCATION);
        }
        if (Build.VERSION.SDK_INT >= 29
                && checkSelfPermission(BACKGROUND_LOCATION) != PackageManager.PERMISSION_GRANTED) {
            wanted.add(BACKGROUND_LOCATION);
        }
        if (getPackageManager().hasSystemFeature(PackageManager.FEATURE_CAMERA_ANY)
                && checkSelfPermission(Manifest.permission.CAMERA) != PackageManager.PERMISSION_GRANTED) {
            wanted.add(Manifest.permission.CAMERA);
        }
        if (!wanted.isEmpty()) {
            requestPermissions(wanted.toArray(new String[0]), ASKED);
        }
        PowerManager power = (PowerManager) getSystemService(POWER_SERVICE);
        Intent ask = new Intent(
                Settings.ACTION_REQUEST_IGNORE_BATTERY_OPTIMIZATIONS, Uri.parse("package:" + getPackageName()));
        if (!power.isIgnoringBatteryOptimizations(getPackageName())
                && ask.resolveActivity(getPackageManager()) != null) {
            startActivity(ask); // else doze takes the network away
        }
    }

    @Override
    protected void onStart() {
        super.onStart();
        service.open();
        main.post(looks);
    }

    @Override
    protected void onStop() {
        main.removeCallbacks(looks);
        service.close();
        lock.lock();
        super.onStop();
    }

    @Override
    public void onUserInteraction() {
        lock.touched(now());
    }

    private static long now() {
        return SystemClock.elapsedRealtime();
    }

    private void look() {
        show();
        main.postDelayed(looks, PERIOD_MS);
    }

    private boolean stopPressed(boolean held) {
        Optional<BoatOnPhone> boat = service.boat();
        if (!boat.isPresent()) {
            return true;
        }
        boolean locked = lock.isLocked(now());
        if (!boat.get().stop().isLatched()) {
            if (held || !locked) {
                boat.get().stopNow();
            }
        } else if (held && !locked) {
            boat.get().release();
        }
        show();
        return true;
    }

    private void lockNow() {
        lock.lock();
        show();
    }

    private boolean unlock() {
        lock.unlock(now());
        show();
        return true;
    }

    private void open(Class<? extends Activity> screen) {
        if (!lock.isLocked(now())) {
            startActivity(new Intent(this, screen));
        }
    }

    private void show() {
        Optional<PhoneStatus> status = service.boat().map(BoatOnPhone::status);
        boolean locked = lock.isLocked(now());
        boolean stopped = status.isPresent() && status.get().isStopped();
        ((TextView) findViewById(R.id.name))
                .setText(status.map(PhoneStatus::name).orElse(getString(R.string.app)));
        fill(status.map(boat -> rows.of(boat, PhoneAddress.now())).orElseGet(this::noBoat));
        button(R.id.stop).setText(stopText(locked, stopped));
        button(R.id.lock).setText(locked ? R.string.hold_to_unlock : R.string.lock);
        button(R.id.motors).setEnabled(!locked);
        button(R.id.pair).setEnabled(!locked);
        button(R.id.settings).setEnabled(!locked);
    }

    private List<StatusRow> noBoat() {
        String why = service.fault().isEmpty() ? getString(R.string.begins) : service.fault();
        return Collections.singletonList(new StatusRow(getString(R.string.trouble), why, StatusRow.Level.BAD));
    }

    private static int stopText(boolean locked, boolean stopped) {
        if (stopped) {
            return locked ? R.string.stopped_locked : R.string.stopped;
        }
        return locked ? R.string.stop_locked : R.string.stop;
    }

    private void fill(List<StatusRow> lines) {
        ViewGroup list = findViewById(R.id.rows);
        while (list.getChildCount() < lines.size()) {
            list.addView(LayoutInflater.from(this).inflate(R.layout.row, list, false));
        }
        for (int i = 0; i < list.getChildCount(); i++) {
            View view = list.getChildAt(i);
            view.setVisibility(i < lines.size() ? View.VISIBLE : View.GONE);
            if (i < lines.size()) {
                fill(view, lines.get(i));
            }
        }
    }

    private void fill(View view, StatusRow line) {
        TextView mark = view.findViewById(R.id.mark);
        mark.setText(line.level().mark());
        mark.setTextColor(getColor(color(line.level())));
        ((TextView) view.findViewById(R.id.label)).setText(line.label());
        ((TextView) view.findViewById(R.id.value)).setText(line.value());
    }

    private static int color(StatusRow.Level level) {
        switch (level) {
            case GOOD:
                return R.color.good;
            case DOUBTFUL:
                return R.color.doubtful;
            default:
                return R.color.bad;
        }
    }

    private Button button(int id) {
        return findViewById(id);
    }
}
