package org.sami.crw.operator;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.Consumer;
import org.sami.crw.operator.boat.BoatSnapshot;
import org.sami.spn.value.NaturalOrder;

/**
 * The boats by their names, as they were known last: each at most ten times a second. What a slow owner's thread has not looked at yet is replaced by
 * what is newer, so that telemetry never piles up.
 */
public final class FleetModel extends Model<List<BoatSnapshot>> {
    private final Consumer<Runnable> inbox;
    private final Listener listener;
    private final Map<String, Optional<BoatSnapshot>> waiting = new ConcurrentHashMap<>();
    private final Map<String, BoatSnapshot> boats = new TreeMap<>(NaturalOrder.INSTANCE);

    /** Other models that follow boats; notified on the owner's thread. */
    interface Listener {
        void seen(BoatSnapshot boat);

        void gone(String boat);
    }

    /** Knows no boat. */
    FleetModel(Consumer<Runnable> inbox, Listener listener) {
        super(List.of());
        this.listener = listener;
        this.inbox = inbox;
    }

    /** A boat is known as this now; empty where it is gone. From any thread. */
    void seen(String boat, Optional<BoatSnapshot> snapshot) {
        if (waiting.put(boat, snapshot) == null) {
            inbox.accept(() -> arrived(boat));
        }
    }

    /** A boat is known as this now, nothing of what came before being left out. On the owner's thread. */
    void show(BoatSnapshot boat) {
        boats.put(boat.boat(), boat);
        listener.seen(boat);
        change();
    }

    /** A boat is known as this now, which is no news to other models. On the owner's thread. */
    void refresh(BoatSnapshot boat) {
        boats.put(boat.boat(), boat);
        change();
    }

    /** Forgets all. On the owner's thread. */
    void clear() {
        boats.keySet().forEach(listener::gone);
        boats.clear();
        change();
    }

    /** A boat is gone. On the owner's thread. */
    void remove(String boat) {
        boats.remove(boat);
        listener.gone(boat);
        change();
    }

    private void arrived(String boat) {
        Optional<BoatSnapshot> latest = waiting.remove(boat);
        if (latest.isPresent()) {
            show(latest.get());
        } else {
            remove(boat);
        }
    }

    @Override
    List<BoatSnapshot> take() {
        return List.copyOf(boats.values());
    }

    /** One boat. From any thread. */
    public Optional<BoatSnapshot> boat(String boat) {
        return snapshot().stream().filter(one -> one.boat().equals(boat)).findFirst();
    }
}
