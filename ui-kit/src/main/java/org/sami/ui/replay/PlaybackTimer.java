package org.sami.ui.replay;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalLong;
import java.util.concurrent.Executor;
import java.util.function.LongConsumer;
import javax.swing.Timer;
import org.sami.spn.replay.Playback;
import org.sami.spn.replay.TimeLine;
import org.sami.ui.EventThread;

/**
 * Keeps a replay at the moment that a person wants: while it plays, by this machine's clock. The moment is computed on the replay's thread, one at
 * a time; of the moments requested meanwhile the last counts. On the event thread.
 */
public final class PlaybackTimer {
    private static final int PERIOD_MS = 50;
    private static final long NANOS_A_MS = 1_000_000;

    private LongConsumer computing;
    private final Executor worker;
    private TimeLine timeLine;
    private Playback playback;
    private final List<Runnable> listeners = new ArrayList<>();
    private final Timer timer = new Timer(PERIOD_MS, e -> tick());
    private OptionalLong wanted = OptionalLong.empty();
    private boolean under; // way: a moment is computed
    private long tickedNanos;

    /**
     * A player that stands at the start.
     *
     * @param computing goes to a moment, in ms of the session's clock; runs on the worker
     * @param worker the replay's thread
     */
    public PlaybackTimer(TimeLine timeLine, LongConsumer computing, Executor worker) {
        this.timeLine = timeLine;
        this.computing = computing;
        this.worker = worker;
        playback = new Playback(timeLine);
    }

    /** Has another replay, and stands at its start. */
    public void show(TimeLine next, LongConsumer computingIt) {
        timer.stop();
        timeLine = next;
        computing = computingIt;
        playback = new Playback(next);
        moved();
    }

    /** When what happened. */
    public TimeLine timeLine() {
        return timeLine;
    }

    /** The requested moment, the speed, and whether it plays. */
    public Playback playback() {
        return playback;
    }

    /** Whether the shown moment is not yet the requested one. */
    public boolean isComputing() {
        return under;
    }

    /** Calls a listener when the moment, the speed, or whether it plays has changed. */
    public void addListener(Runnable listener) {
        listeners.add(listener);
    }

    /** Plays, or pauses. */
    public void toggle() {
        playback.toggle();
        tickedNanos = System.nanoTime();
        if (playback.isPlaying()) {
            timer.start();
        }
        moved();
    }

    /** Goes to a moment, playing on if it plays. */
    public void goTo(long millis) {
        playback.goTo(millis);
        moved();
    }

    /** Stands at the step of the engine before or after. */
    public void step(boolean forwards) {
        playback.step(forwards);
        moved();
    }

    /** Goes to the mark before or after. */
    public void toMark(boolean forwards) {
        playback.toMark(forwards);
        moved();
    }

    /** Plays faster or slower. */
    public void change(boolean faster) {
        playback.change(faster);
        tell();
    }

    /** Plays so many times as fast as it happened; one of {@link Playback#SPEEDS}. */
    public void setSpeed(double times) {
        playback.setSpeed(times);
        tell();
    }

    /** Pauses, where something that was waited for is so now. */
    public void pause() {
        playback.pause();
        tell();
    }

    /** Ends it. */
    public void close() {
        timer.stop();
    }

    private void tick() {
        long now = System.nanoTime();
        playback.passed((now - tickedNanos) / NANOS_A_MS);
        tickedNanos += (now - tickedNanos) / NANOS_A_MS * NANOS_A_MS;
        if (!playback.isPlaying()) {
            timer.stop();
        }
        moved();
    }

    private void moved() {
        wanted = OptionalLong.of(playback.atMillis());
        compute();
        tell();
    }

    private void compute() {
        if (!under && wanted.isPresent()) {
            long to = wanted.getAsLong();
            wanted = OptionalLong.empty();
            under = true;
            worker.execute(() -> {
                computing.accept(to);
                EventThread.later(this::computed);
            });
        }
    }

    private void computed() {
        under = false;
        compute();
        tell();
    }

    private void tell() {
        listeners.forEach(Runnable::run);
    }
}
