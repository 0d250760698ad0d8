package org.sami.ui.map;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.function.Consumer;
import org.sami.ui.EventThread;
import org.sami.ui.map.base.BaseSource;

/**
 * The one thread that asks a base map for pictures, one after the other, and closes it at its end. What has come meanwhile is handed to the event
 * thread together: it is never given more than one task, however many pictures there are.
 */
final class TileReader implements AutoCloseable {
    /** A picture that has come, or the reason why there is none. */
    record Answer(StoredTile tile, Optional<BufferedImage> image, Optional<String> problem) {}

    private final BaseSource source;
    private final Consumer<List<Answer>> taker;
    private final BlockingQueue<StoredTile> asked = new LinkedBlockingQueue<>();
    private final Thread thread;
    private List<Answer> answers = new ArrayList<>(); // guarded by this

    /**
     * A reader that waits for questions.
     *
     * @param taker is handed what has come, on the event thread
     */
    TileReader(BaseSource source, Consumer<List<Answer>> taker) {
        this.source = source;
        this.taker = taker;
        thread = new Thread(this::run, "map-tiles");
        thread.setDaemon(true);
        thread.start();
    }

    void ask(StoredTile tile) {
        asked.add(tile);
    }

    /** Takes a question back; false where it is being answered already. */
    boolean withdraw(StoredTile tile) {
        return asked.remove(tile);
    }

    private void run() {
        try {
            while (!Thread.currentThread().isInterrupted()) {
                StoredTile tile = asked.take();
                answer(read(tile));
            }
        } catch (InterruptedException closed) {
            Thread.currentThread().interrupt();
        } finally {
            close(source);
        }
    }

    private Answer read(StoredTile tile) {
        try {
            return new Answer(tile, source.tile(tile.key(), tile.style()), Optional.empty());
        } catch (IOException | RuntimeException e) {
            return new Answer(tile, Optional.empty(), Optional.of(String.valueOf(e.getMessage())));
        } catch (OutOfMemoryError full) {
            return new Answer(
                    tile, Optional.empty(), Optional.of("There is too little memory for the map " + source.name()));
        }
    }

    private void answer(Answer answer) {
        boolean first;
        synchronized (this) {
            answers.add(answer);
            first = answers.size() == 1;
        }
        if (first) {
            EventThread.later(this::hand);
        }
    }

    private void hand() {
        List<Answer> come;
        synchronized (this) {
            come = answers;
            answers = new ArrayList<>();
        }
        taker.accept(come);
    }

    /** Leaves what is being read, and closes the source, beside the caller's thread. */
    @Override
    public void close() {
        asked.clear();
        thread.interrupt();
    }

    private static void close(BaseSource source) {
        try {
            source.close();
        } catch (IOException e) {
            // nothing was written to it
        }
    }
}
