package org.sami.crw.mavlink;

import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.Executor;
import org.sami.mavlink.base.MavlinkBase;
import org.sami.mavlink.vehicle.VehicleId;

/**
 * Parameters that a vehicle was read to hold, and that others may change: it is asked for them again once a minute and as a base comes, and says by itself what others
 * set. For the gateway's thread.
 */
final class WatchedParameters {
    private static final long EVERY_MS = 60_000;
    private static final long JUST_READ_MS = 10_000;

    /** A parameter is another than it was. */
    interface Change {
        /** @param words which it is now, and what it was: {@code FENCE_ENABLE 0, before 1} */
        void found(String name, double value, String words);
    }

    private final MavlinkBase base;
    private final VehicleId id;
    private final Executor thread;
    private final Change changed;
    private final Map<String, Double> held = new LinkedHashMap<>();
    private long nowMs;
    private long readMs;
    private boolean paused;
    private int turn; // of what is asked; a later one makes an earlier one void
    private Optional<Integer> asking = Optional.empty(); // the turn that asks

    /**
     * Nothing is watched yet.
     *
     * @param changed receives which of them somebody else has changed
     */
    WatchedParameters(MavlinkBase base, VehicleId id, Executor thread, Change changed) {
        this.base = base;
        this.id = id;
        this.thread = thread;
        this.changed = changed;
    }

    /** It was read just now to hold this value, which is watched from now on. */
    void holds(String name, double value) {
        held.put(name, value);
        readMs = nowMs;
    }

    /** What it holds is being set or read: nothing is asked or told before {@link #resume}. */
    void pause() {
        paused = true;
        turn++;
        asking = Optional.empty();
    }

    /** What it holds now was told with {@link #holds}. */
    void resume() {
        paused = false;
    }

    /** Nothing is watched any longer. */
    void forget() {
        held.clear();
        turn++;
        asking = Optional.empty();
    }

    /** A base has come: it is asked at the next tick, unless it was read just now. */
    void askSoon() {
        if (nowMs - readMs > JUST_READ_MS) {
            readMs = nowMs - EVERY_MS;
        }
    }

    /** To be called often. */
    void tick(long atMs, boolean isCommanded) {
        nowMs = atMs;
        if (isCommanded && !paused && !held.isEmpty() && asking.isEmpty() && atMs - readMs >= EVERY_MS) {
            readMs = atMs;
            asking = Optional.of(++turn);
            ask(turn, List.copyOf(held.keySet()).iterator());
        }
    }

    private void ask(int asked, Iterator<String> names) {
        if (asked != turn) {
            return;
        }
        if (!names.hasNext()) {
            asking = Optional.empty();
            return;
        }
        String name = names.next();
        Results.when(
                base.parameter(id, name),
                thread,
                value -> {
                    if (asked == turn) {
                        compare(name, value);
                    }
                    ask(asked, names);
                },
                unanswered -> ask(asked, names)); // it is asked again in a minute
    }

    /** The vehicle has said what a parameter is, to whomever. */
    void reported(String name, double value) {
        if (!paused) {
            compare(name, value);
        }
    }

    private void compare(String name, double value) {
        Double before = held.get(name);
        if (before != null && Double.compare(before, value) != 0) {
            held.put(name, value);
            changed.found(name, value, name + " " + text(value) + ", before " + text(before));
        }
    }

    private static String text(double value) {
        return value == Math.rint(value) ? Long.toString(Math.round(value)) : String.format(Locale.ROOT, "%.2f", value);
    }
}
