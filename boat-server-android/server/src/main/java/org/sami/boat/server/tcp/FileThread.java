package org.sami.boat.server.tcp;

import java.util.concurrent.Executor;
import java.util.concurrent.Future;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.ScheduledThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import org.sami.boat.link.FileAnswer;
import org.sami.boat.link.FileRequest;
import org.sami.boat.server.FileProvider;
import org.sami.boat.server.file.BoatFiles;

/**
 * Reads files for the clients of a boat on a thread of its own, one request after another, and not more than so many a second for all clients together. The thread
 * exists once a client has asked. For the boat's thread.
 */
final class FileThread implements FileProvider {
    /** Time between two answers in ms: 50 pieces a second, 300 kB, which is a sixth of a slow Wi-Fi. */
    static final long APART_MS = 20;

    private final BoatFiles files;
    private final Executor boatThread;
    private final ScheduledThreadPoolExecutor thread;
    private long nextNanos;
    private boolean begun;

    FileThread(String boat, BoatFiles files, Executor boatThread) {
        this.files = files;
        this.boatThread = boatThread;
        thread = new ScheduledThreadPoolExecutor(1, work -> {
            Thread made = new Thread(work, boat + "-files");
            made.setDaemon(true);
            return made;
        });
        thread.setExecuteExistingDelayedTasksAfterShutdownPolicy(false);
    }

    @Override
    public void asked(FileRequest request, Consumer<FileAnswer> answer) {
        long nowNanos = System.nanoTime();
        long atNanos = begun && nextNanos - nowNanos > 0 ? nextNanos : nowNanos;
        begun = true;
        nextNanos = atNanos + TimeUnit.MILLISECONDS.toNanos(APART_MS);
        try {
            Future<?> unused = thread.schedule(
                    () -> {
                        FileAnswer found = files.answer(request);
                        boatThread.execute(() -> answer.accept(found));
                    },
                    atNanos - nowNanos,
                    TimeUnit.NANOSECONDS);
        } catch (RejectedExecutionException e) {
            // the server stops, and with it the client's link
        }
    }

    /** Ends the thread, and waits for that at most so long. */
    void close(long withinMs) throws InterruptedException {
        thread.shutdownNow();
        thread.awaitTermination(withinMs, TimeUnit.MILLISECONDS);
    }
}
