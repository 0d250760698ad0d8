package org.sami.boat.app.screen;

import android.content.ComponentName;
import android.content.Context;
import android.content.Intent;
import android.content.ServiceConnection;
import android.os.IBinder;
import java.util.Optional;
import org.sami.boat.app.BoatService;
import org.sami.boat.app.boat.BoatOnPhone;

/** A screen's way to the boat, while the screen is shown. For the main thread. */
final class ServiceLink implements ServiceConnection {
    private final Context context;
    private final Runnable whenThere;
    private Optional<BoatService.Link> link = Optional.empty();

    ServiceLink(Context context, Runnable whenThere) {
        this.context = context;
        this.whenThere = whenThere;
    }

    void open() {
        BoatService.begin(context);
        context.bindService(new Intent(context, BoatService.class), this, Context.BIND_AUTO_CREATE);
    }

    void close() {
        context.unbindService(this);
        link = Optional.empty();
    }

    /** The boat; empty where it is not there, or not yet. */
    Optional<BoatOnPhone> boat() {
        return link.flatMap(BoatService.Link::boat);
    }

    /** Why there is no boat; empty where there is one, or not yet. */
    String fault() {
        return link.map(BoatService.Link::fault).orElse("");
    }

    void beginAnew() {
        link.ifPresent(BoatService.Link::beginAnew);
    }

    @Override
    public void onServiceConnected(ComponentName name, IBinder binder) {
        link = Optional.of((BoatService.Link) binder);
        whenThere.run();
    }

    @Override
    public void onServiceDisconnected(ComponentName name) {
        link = Optional.empty();
    }
}
