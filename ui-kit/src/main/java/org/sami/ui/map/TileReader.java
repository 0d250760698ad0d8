package org.sami.ui.map;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import org.sami.ui.EventThread;
import org.sami.ui.map.base.BaseSource;

/**
 * The one thread that asks a base map for pictures, one after the other. It ends when nothing was asked for a while, and comes again. What has come
 * meanwhile is handed to the event thread together: it is never given more than one task, however many pictures there are.
 */
final class TileReader implements AutoCloseable {
    private static final int IDLE_S = 5;

    /** A picture that has come, or the reason why there is none. */
    record Answer(StoredTile tile, Optional<BufferedImage> image, Optional<String> problem) {}

    private final BaseSource source;
    private final Consumer<List<Answer>> taker;
    private final Queue<StoredTile> asked = new ConcurrentLinkedQueue<>();
    private final ThreadPoolExecutor thread;
    private List<Answer> answers = new ArrayList<>(); // guarded by this

    /**
     * A reader that waits for questions.
     *
     * @param owns whether it closes the source in the end; else somebody else does, and it may be closed at any time
     * @param taker is handed what has come, on the event thread
     */
    TileReader(BaseSource source, boolean owns, Consumer<List<Answer>> taker) {
        this.source = source;
        this.taker = taker;
        thread =
                new ThreadPoolExecutor(
                        1, 1, IDLE_S, TimeUnit.SECONDS, new LinkedBlockingQueue<>(), TileReader::daemon) {
                    @Override
                    protected void terminated() {
                        if (owns) {
                            daemon(() -> close(source)).start(); // another map's reader may be in it
                        }
                    }
                };
        thread.allowCoreThreadTimeOut(true);
    }

    private static Thread daemon(Runnable work) {
        Thread thread = new Thread(work, "map-tiles");
        thread.setDaemon(true);
        return thread;
    }

    /** Asks for a picture; does nothing where it was closed. */
    void ask(StoredTile tile) {
        if (!thread.isShutdown()) {
            asked.add(tile);
            thread.execute(this::next);
        }
    }

    /** Takes a question back; false where it is being answered already. */
    boolean withdraw(StoredTile tile) {
        return asked.remove(tile);
    }

    private void next() {
        StoredTile tile = asked.poll();
        if (tile != null) {
            answer(read(tile));
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

    /** Leaves what is being read, and closes a source that it owns, both off the caller's thread. On the event thread, as asking is. */
    @Override
    public void close() {
        asked.clear();
        thread.shutdownNow();
    }

    private static void close(BaseSource source) {
        try {
            source.close();
        } catch (IOException e) {
            // nothing was written to it
        }
    }
}
