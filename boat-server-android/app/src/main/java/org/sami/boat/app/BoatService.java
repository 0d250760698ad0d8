package org.sami.boat.app;

import android.app.Service;
import android.content.Context;
import android.content.Intent;
import android.os.Binder;
import android.os.Handler;
import android.os.IBinder;
import android.os.Looper;
import android.os.SystemClock;
import android.util.Log;
import java.io.IOException;
import java.net.InetSocketAddress;
import java.util.Optional;
import java.util.Random;
import org.jspecify.annotations.Nullable;
import org.sami.boat.app.boat.AppFiles;
import org.sami.boat.app.boat.BoatOnPhone;
import org.sami.boat.app.boat.PhoneHealth;
import org.sami.boat.app.boat.PhoneSettings;
import org.sami.boat.app.phone.BackCamera;
import org.sami.boat.app.phone.PhoneAnnouncer;
import org.sami.boat.app.phone.PhonePosition;
import org.sami.boat.app.phone.PhoneWatch;
import org.sami.boat.app.phone.UsbBoardPort;
import org.sami.boat.link.SteadyClock;

/**
 * The service in the foreground that keeps the boat alive: with the screen off, with the app swiped away, and again after the system has killed it. A
 * permission that is given later is used within seconds.
 */
public final class BoatService extends Service {
    private static final String TAG = "sami";
    private static final long LOOK_MS = 2000;

    private final Handler main = new Handler(Looper.getMainLooper());
    private final Runnable looks = this::look;
    private PhoneLocks locks;
    private PhoneAnnouncer announcer;
    private BoatNotification notification;
    private Optional<Parts> parts = Optional.empty();
    private String fault = "";

    /** Begins the service, unless it runs. */
    public static void begin(Context context) {
        context.startForegroundService(new Intent(context, BoatService.class));
    }

    /** How a screen of this app reaches the service. */
    public final class Link extends Binder {
        /** The boat; empty where it cannot be begun. */
        public Optional<BoatOnPhone> boat() {
            return parts.map(all -> all.boat);
        }

        /** Why there is no boat, in words; empty where there is one. */
        public String fault() {
            return fault;
        }

        /** Reads name and port again, and begins the boat again with them. */
        public void beginAnew() {
            endBoat();
            beginBoat();
        }
    }

    @Override
    public void onCreate() {
        super.onCreate();
        notification = new BoatNotification(this);
        startForeground(BoatNotification.ID, notification.saying(getString(R.string.begins)));
        locks = new PhoneLocks(this);
        locks.take();
        announcer = new PhoneAnnouncer(this);
        beginBoat();
        main.post(looks);
    }

    /** Sticky: after a kill the system begins the service again by itself. */
    @Override
    public int onStartCommand(@Nullable Intent intent, int flags, int startId) {
        return START_STICKY;
    }

    @Override
    public IBinder onBind(Intent intent) {
        return new Link();
    }

    private void beginBoat() {
        try {
            parts = Optional.of(new Parts());
            fault = "";
        } catch (IOException e) {
            fault = "the boat cannot begin: " + e.getMessage();
            said(fault);
        }
    }

    private void endBoat() {
        parts.ifPresent(Parts::end);
        parts = Optional.empty();
    }

    private void look() {
        if (!parts.isPresent()) {
            beginBoat();
        }
        parts.ifPresent(Parts::look);
        main.postDelayed(looks, LOOK_MS);
    }

    private void said(String text) {
        Log.i(TAG, text);
        main.post(() -> notification.show(text));
    }

    @Override
    public void onDestroy() {
        main.removeCallbacksAndMessages(null);
        endBoat();
        locks.giveBack();
        super.onDestroy();
    }

    /** The boat and what it is fed by. */
    private final class Parts {
        private final BoatOnPhone boat;
        private final PhonePosition position;
        private final PhoneWatch watch;

        Parts() throws IOException {
            AppFiles files = new AppFiles(getFilesDir().toPath());
            SteadyClock clock = new SteadyClock(SystemClock::elapsedRealtime); // it counts while the phone sleeps
            boat = new BoatOnPhone(
                    files,
                    PhoneSettings.readOrMake(files, new Random()),
                    new InetSocketAddress(0).getAddress(), // all networks of the phone
                    new UsbBoardPort(BoatService.this),
                    new BackCamera(BoatService.this),
                    new PhoneHealth(),
                    clock,
                    BoatService.this::said);
            position = new PhonePosition(BoatService.this, boat.position(), clock);
            watch = new PhoneWatch(BoatService.this, boat.health(), getFilesDir());
            watch.begin();
            position.begin();
            boat.start();
        }

        void look() {
            position.begin();
            watch.look();
            boat.announcement()
                    .ifPresent(text -> announcer.announce(text, boat.status().port()));
        }

        void end() {
            announcer.end();
            position.end();
            watch.end();
            try {
                boat.close();
            } catch (IOException e) {
                Log.w(TAG, "the boat ends", e);
            }
        }
    }
}
