package org.sami.boat.app;

import android.app.Service;
import android.content.Context;
import android.content.Intent;
import android.os.IBinder;
import org.jspecify.annotations.Nullable;

/**
 * The service in the foreground that keeps the boat alive: with the screen off, with the app swiped away, and again after the system has killed it.
 */
public final class BoatService extends Service {
    private PhoneLocks locks;

    /** Begins the service, unless it runs. */
    public static void begin(Context context) {
        context.startForegroundService(new Intent(context, BoatService.class));
    }

    @Override
    public void onCreate() {
        super.onCreate();
        startForeground(BoatNotification.ID, new BoatNotification(this).saying(getString(R.string.begins)));
        locks = new PhoneLocks(this);
        locks.take();
    }

    /** Sticky: after a kill the system begins the service again by itself. */
    @Override
    public int onStartCommand(@Nullable Intent intent, int flags, int startId) {
        return START_STICKY;
    }

    @Override
    public @Nullable IBinder onBind(Intent intent) {
        return null;
    }

    @Override
    public void onDestroy() {
        locks.giveBack();
        super.onDestroy();
    }
}
