package org.sami.crw.gui;

import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import java.util.function.Supplier;
import org.sami.ui.EventThread;

/** Acts on views as the event thread does, and waits for what comes of it: for tests only. */
public final class EventThreadCall {
    private static final int WITHIN_S = 300;

    private EventThreadCall() {}

    /** What an action yields on the event thread; what it throws is thrown here. */
    public static <T> T onEventThread(Supplier<T> action) {
        if (EventThread.isCurrent()) {
            return action.get();
        }
        CompletableFuture<T> done = new CompletableFuture<>();
        EventThread.later(() -> {
            try {
                done.complete(action.get());
            } catch (Throwable fault) {
                done.completeExceptionally(fault);
            }
        });
        return done.orTimeout(WITHIN_S, TimeUnit.SECONDS).join();
    }
}
