package org.sami.boat.app.phone;

import android.content.BroadcastReceiver;
import android.content.Context;
import android.content.Intent;
import android.content.IntentFilter;
import android.os.BatteryManager;
import android.os.StatFs;
import android.os.SystemClock;
import java.io.File;
import java.util.function.LongSupplier;
import org.sami.boat.app.boat.PhoneHealth;

/** Watches the phone's battery, heat, storage and date. For the main thread. */
public final class PhoneWatch {
    private static final double NOT_SET_S = 2; // networks correct phones by less
    private static final long MADE_MS = 1_767_225_600_000L; // 2026-01-01, before which this app was not there

    private final Context context;
    private final PhoneHealth health;
    private final File folder;
    private final LongSupplier dateMs;
    private final Receiver receiver = new Receiver();
    private long dateAtStartMs;

    /**
     * A watch that has not begun.
     *
     * @param folder on whose storage the app writes
     */
    public PhoneWatch(Context context, PhoneHealth health, File folder) {
        this(context, health, folder, System::currentTimeMillis);
    }

    PhoneWatch(Context context, PhoneHealth health, File folder, LongSupplier dateMs) {
        this.context = context;
        this.health = health;
        this.folder = folder;
        this.dateMs = dateMs;
    }

    /** Begins; what is known is reported at once. */
    public void begin() {
        dateAtStartMs = dateAtStart();
        IntentFilter changes = new IntentFilter(Intent.ACTION_BATTERY_CHANGED);
        changes.addAction(Intent.ACTION_TIME_CHANGED);
        context.registerReceiver(receiver, changes);
        look();
    }

    /** Looks at storage and date; to be called now and then. */
    public void look() {
        health.setDateLost(dateMs.getAsLong() < MADE_MS);
        health.setFreeMegabytes(new StatFs(folder.getPath()).getAvailableBytes() / 1e6);
    }

    /** Ends. */
    public void end() {
        context.unregisterReceiver(receiver);
    }

    private long dateAtStart() {
        return dateMs.getAsLong() - SystemClock.elapsedRealtime();
    }

    /** What the phone tells. */
    private final class Receiver extends BroadcastReceiver {
        @Override
        public void onReceive(Context from, Intent intent) {
            if (Intent.ACTION_TIME_CHANGED.equals(intent.getAction())) {
                double byS = (dateAtStart() - dateAtStartMs) / 1000.0;
                dateAtStartMs = dateAtStart();
                if (Math.abs(byS) >= NOT_SET_S) {
                    health.clockSet(byS);
                }
            } else {
                int level = intent.getIntExtra(BatteryManager.EXTRA_LEVEL, -1);
                int scale = intent.getIntExtra(BatteryManager.EXTRA_SCALE, -1);
                int tenths = intent.getIntExtra(BatteryManager.EXTRA_TEMPERATURE, Integer.MIN_VALUE);
                health.setBattery(
                        level >= 0 && scale > 0 ? 100.0 * level / scale : Double.NaN,
                        tenths == Integer.MIN_VALUE ? Double.NaN : tenths / 10.0);
            }
        }
    }
}
