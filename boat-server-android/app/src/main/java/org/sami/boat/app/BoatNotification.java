package org.sami.boat.app;

import android.app.Notification;
import android.app.NotificationChannel;
import android.app.NotificationManager;
import android.content.Context;

/** The notification with which the service stays in the foreground. */
final class BoatNotification {
    /** Its number among the app's notifications. */
    static final int ID = 1;

    private static final String CHANNEL = "boat";

    private final Context context;

    BoatNotification(Context context) {
        this.context = context;
        NotificationChannel channel = new NotificationChannel(
                CHANNEL, context.getString(R.string.channel), NotificationManager.IMPORTANCE_LOW); // without a sound
        manager().createNotificationChannel(channel);
    }

    /** The notification with a text. */
    Notification saying(String text) {
        return new Notification.Builder(context, CHANNEL)
                .setSmallIcon(R.drawable.boat)
                .setContentTitle(context.getString(R.string.app))
                .setContentText(text)
                .setOngoing(true)
                .build();
    }

    /** Shows another text. */
    void show(String text) {
        manager().notify(ID, saying(text));
    }

    private NotificationManager manager() {
        return (NotificationManager) context.getSystemService(Context.NOTIFICATION_SERVICE);
    }
}
