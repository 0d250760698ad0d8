package org.sami.crw.cli.output;

import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.function.BooleanSupplier;

/**
 * Lets Ctrl-C end a run in order: the run sees that it is to stop, closes its journal and says how to go on, and only then
 * does the process end. A run that does not come to its end within some seconds is left behind; its journal is safe.
 */
public final class StopOnInterrupt implements BooleanSupplier, AutoCloseable {
    private static final long TIMEOUT_S = 10;

    private final CountDownLatch done = new CountDownLatch(1);
    private final Thread hook = new Thread(this::stop, "stop on interrupt");
    private final Thread running = Thread.currentThread();
    private volatile boolean asked;

    public StopOnInterrupt() {
        Runtime.getRuntime().addShutdownHook(hook);
    }

    /** Whether the run is to stop. */
    @Override
    public boolean getAsBoolean() {
        return asked;
    }

    private void stop() {
        asked = true;
        running.interrupt(); // out of the pacer's wait
        try {
            done.await(TIMEOUT_S, TimeUnit.SECONDS);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    /** Everything is printed and closed: the process may end. */
    @Override
    public void close() {
        done.countDown();
        if (!asked) {
            try {
                Runtime.getRuntime().removeShutdownHook(hook);
            } catch (IllegalStateException e) {
                // the process is ending already
            }
        }
    }
}
