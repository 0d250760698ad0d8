package org.sami.boat.app;

import android.content.Context;
import android.net.wifi.WifiManager;
import android.os.PowerManager;

/**
 * Keeps the phone's processor and its Wi-Fi at full power, with the screen off too. For the main thread.
 */
final class PhoneLocks {
    private static final String TAG = "sami:boat";

    private final PowerManager.WakeLock processor;
    private final WifiManager.WifiLock wifi;

    PhoneLocks(Context context) {
        PowerManager power = (PowerManager) context.getSystemService(Context.POWER_SERVICE);
        processor = power.newWakeLock(PowerManager.PARTIAL_WAKE_LOCK, TAG);
        processor.setReferenceCounted(false);
        WifiManager manager = (WifiManager) context.getApplicationContext().getSystemService(Context.WIFI_SERVICE);
        wifi = manager.createWifiLock(WifiManager.WIFI_MODE_FULL_HIGH_PERF, TAG);
        wifi.setReferenceCounted(false);
    }

    /** Takes both locks; again does nothing. */
    void take() {
        processor.acquire(); // without a time limit: a mission has none
        wifi.acquire();
    }

    /** Gives both back. */
    void giveBack() {
        wifi.release();
        processor.release();
    }

    /** Whether both are held. */
    boolean areHeld() {
        return processor.isHeld() && wifi.isHeld();
    }
}
