package org.sami.crw.gui.sound;

import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import javax.sound.sampled.AudioFormat;
import javax.sound.sampled.AudioSystem;
import javax.sound.sampled.LineUnavailableException;
import javax.sound.sampled.SourceDataLine;

/** This machine's loudspeaker. Plays on a thread of its own; a machine without one says so once, and is silent from then on. */
public final class Loudspeaker implements AutoCloseable {
    private static final System.Logger LOG = System.getLogger(Loudspeaker.class.getName());
    private static final AudioFormat FORMAT = new AudioFormat(AlarmTone.RATE_HZ, 16, 1, true, false);

    /** One plays and one waits; what comes while one waits is left out, as a later alarm repeats it. */
    private final ThreadPoolExecutor thread = new ThreadPoolExecutor(
            1,
            1,
            0,
            TimeUnit.SECONDS,
            new LinkedBlockingQueue<>(1),
            work -> {
                Thread made = new Thread(work, "sound");
                made.setDaemon(true);
                return made;
            },
            new ThreadPoolExecutor.DiscardPolicy());

    private final Opening opening;
    private final Consumer<String> silent;
    private volatile boolean broken;

    /** Opens the way to a loudspeaker. */
    @FunctionalInterface
    interface Opening {
        SourceDataLine open(AudioFormat format) throws LineUnavailableException;
    }

    /**
     * The loudspeaker; nothing is opened before the first tone.
     *
     * @param silent receives once, on any thread, why nothing can be heard
     */
    public Loudspeaker(Consumer<String> silent) {
        this(AudioSystem::getSourceDataLine, silent);
    }

    Loudspeaker(Opening opening, Consumer<String> silent) {
        this.opening = opening;
        this.silent = silent;
    }

    /** Plays a tone; returns at once. */
    public void play(AlarmTone tone) {
        if (!broken) {
            thread.execute(() -> playNow(tone));
        }
    }

    private void playNow(AlarmTone tone) {
        if (broken) {
            return;
        }
        try (SourceDataLine line = opening.open(FORMAT)) {
            byte[] samples = tone.samples();
            line.open(FORMAT);
            line.start();
            line.write(samples, 0, samples.length);
            line.drain();
        } catch (LineUnavailableException | IllegalArgumentException | SecurityException none) {
            broken = true;
            LOG.log(System.Logger.Level.DEBUG, "no line to a loudspeaker", none);
            silent.accept("This machine makes no sound: alarms are seen, and not heard");
        }
    }

    @Override
    public void close() {
        thread.shutdownNow();
    }
}
