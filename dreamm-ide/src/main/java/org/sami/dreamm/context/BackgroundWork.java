package org.sami.dreamm.context;

import java.util.Objects;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.function.Consumer;
import java.util.function.Supplier;
import org.sami.ui.EventThread;

/**
 * Tasks off the event thread, one after another, with one hop back for the result. A task that fails is reported to the author and
 * makes nothing.
 */
public final class BackgroundWork implements AutoCloseable {
    private static final System.Logger LOG = System.getLogger(BackgroundWork.class.getName());

    private final ExecutorService executor = Executors.newSingleThreadExecutor(work -> {
        Thread thread = new Thread(work, "dreamm-work");
        thread.setDaemon(true);
        return thread;
    });
    private final Consumer<String> failed;

    /**
     * Work for a window.
     *
     * @param failed receives on the event thread, in one sentence, what could not be done
     */
    public BackgroundWork(Consumer<String> failed) {
        this.failed = Objects.requireNonNull(failed, "failed");
    }

    /**
     * Does a piece of work when those before it are done.
     *
     * @param what it is, for the sentence that says that it failed, such as "Checking the plan"
     * @param work touches no view
     * @param then is given what the work has made, on the event thread
     */
    public <T> void run(String what, Supplier<T> work, Consumer<T> then) {
        executor.execute(() -> {
            try {
                T made = work.get();
                EventThread.later(() -> then.accept(made));
            } catch (RuntimeException fault) {
                LOG.log(System.Logger.Level.ERROR, what + " failed", fault);
                EventThread.later(() -> failed.accept(what + " failed: " + fault.getMessage()));
            }
        });
    }

    /** Begins nothing new; what is under way ends with the process. */
    @Override
    public void close() {
        executor.shutdownNow();
    }
}
