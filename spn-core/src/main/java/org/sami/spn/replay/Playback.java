package org.sami.spn.replay;

import java.util.List;

/** Plays a time line: whether it runs, how fast, and at which moment it is then. Knows no clock: the caller says how much time has passed. */
public final class Playback {
    /** The speeds that can be chosen. */
    public static final List<Double> SPEEDS = List.of(0.25, 0.5, 1.0, 2.0, 5.0, 10.0, 25.0, 50.0, 100.0);

    private final TimeLine timeLine;
    private double position;
    private int speed = SPEEDS.indexOf(1.0);
    private boolean playing;

    /** Stands at the start. */
    public Playback(TimeLine timeLine) {
        this.timeLine = timeLine;
    }

    /** The moment, in ms of the session's clock. */
    public long atMillis() {
        return (long) position;
    }

    /** Whether it runs. */
    public boolean isPlaying() {
        return playing;
    }

    /** How many times as fast as it happened. */
    public double speed() {
        return SPEEDS.get(speed);
    }

    /** Runs, or stands; at the end it runs from the start. */
    public void toggle() {
        if (!playing && atMillis() >= timeLine.endMillis()) {
            position = 0;
        }
        playing = !playing && timeLine.endMillis() > 0;
    }

    /** Stands. */
    public void pause() {
        playing = false;
    }

    /** Chooses the next higher or lower speed, where there is one. */
    public void change(boolean faster) {
        speed = Math.max(0, Math.min(SPEEDS.size() - 1, speed + (faster ? 1 : -1)));
    }

    /**
     * Chooses a speed.
     *
     * @throws IllegalArgumentException if it is none of {@link #SPEEDS}
     */
    public void setSpeed(double times) {
        if (!SPEEDS.contains(times)) {
            throw new IllegalArgumentException("a speed of " + times + "; there are " + SPEEDS);
        }
        speed = SPEEDS.indexOf(times);
    }

    /** Goes to a moment of the time line. */
    public void goTo(long millis) {
        position = Math.max(0, Math.min(timeLine.endMillis(), millis));
    }

    /** Stands at the next or the last moment at which the engine took a step. */
    public void step(boolean forwards) {
        pause();
        goTo(forwards ? timeLine.stepAfter(atMillis()) : timeLine.stepBefore(atMillis()));
    }

    /** Stands at the next or the last mark. */
    public void toMark(boolean forwards) {
        goTo(forwards ? timeLine.markAfter(atMillis()) : timeLine.markBefore(atMillis()));
    }

    /** So much time has passed for who watches. At the end it stands. */
    public void passed(long millis) {
        if (playing) {
            position = Math.min((double) timeLine.endMillis(), position + millis * speed());
            playing = position < timeLine.endMillis();
        }
    }
}
