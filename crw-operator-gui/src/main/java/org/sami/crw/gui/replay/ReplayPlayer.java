package org.sami.crw.gui.replay;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalLong;
import java.util.concurrent.Executor;
import javax.swing.Timer;
import org.sami.crw.replay.Playback;
import org.sami.crw.replay.Replay;
import org.sami.crw.replay.TimeLine;
import org.sami.ui.EventThread;

/**
 * Keeps a replay at the moment that a person wants: while it plays, by this machine's clock. The moment is computed on the replay's thread, one at
 * a time; of those that are wanted meanwhile the last counts. On the event thread.
 */
final class ReplayPlayer {
    private static final int PERIOD_MS = 50;
    private static final long NANOS_A_MS = 1_000_000;

    private final Replay replay;
    private final Executor worker;
    private final Playback playback;
    private final List<Runnable> listeners = new ArrayList<>();
    private final Timer timer = new Timer(PERIOD_MS, e -> tick());
    private OptionalLong wanted = OptionalLong.empty();
    private boolean under; // way: a moment is computed
    private long tickedNanos;

    ReplayPlayer(Replay replay, Executor worker) {
        this.replay = replay;
        this.worker = worker;
        playback = new Playback(replay.journal().timeLine());
    }

    TimeLine timeLine() {
        return replay.journal().timeLine();
    }

    Playback playback() {
        return playback;
    }

    /** Whether the moment that is shown is not yet the one that is wanted. */
    boolean isComputing() {
        return under;
    }

    /** Is told when the moment, the speed, or whether it plays has changed. */
    void addListener(Runnable listener) {
        listeners.add(listener);
    }

    void toggle() {
        playback.toggle();
        tickedNanos = System.nanoTime();
        if (playback.isPlaying()) {
            timer.start();
        }
        moved();
    }

    /** Goes to a moment, playing on if it plays. */
    void goTo(long millis) {
        playback.goTo(millis);
        moved();
    }

    void step(boolean forwards) {
        playback.step(forwards);
        moved();
    }

    void toMark(boolean forwards) {
        playback.toMark(forwards);
        moved();
    }

    void change(boolean faster) {
        playback.change(faster);
        tell();
    }

    void setSpeed(double times) {
        playback.setSpeed(times);
        tell();
    }

    void close() {
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
                replay.goTo(to);
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
