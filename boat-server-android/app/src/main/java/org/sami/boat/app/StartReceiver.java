package org.sami.boat.app;

import android.content.BroadcastReceiver;
import android.content.Context;
import android.content.Intent;

/** Begins the service when the phone has started, and when the app was replaced by another version. */
public final class StartReceiver extends BroadcastReceiver {
    @Override
    public void onReceive(Context context, Intent intent) {
        String action = intent.getAction();
        if (Intent.ACTION_BOOT_COMPLETED.equals(action) || Intent.ACTION_MY_PACKAGE_REPLACED.equals(action)) {
            BoatService.begin(context);
        }
    }
}
