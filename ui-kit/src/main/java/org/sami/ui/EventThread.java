package org.sami.ui;

import java.awt.EventQueue;
import java.awt.event.InputEvent;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.Executor;
import java.util.function.Supplier;

/**
 * The one border to Swing's event thread: models and links know no Swing, and hand what a view is to show to {@link #executor()}.
 * No other class of SAMI queues an event or asks which thread it is on (an architecture test holds them to it).
 */
public final class EventThread {
    private EventThread() {}

    /** Runs each task on the event thread, after what is queued there; never waits. It is the owner's executor of a window's models. */
    public static Executor executor() {
        return EventQueue::invokeLater;
    }

    /** Runs a task on the event thread after what is queued there; never waits. */
    public static void later(Runnable task) {
        EventQueue.invokeLater(task);
    }

    /**
     * Runs work on the event thread and waits for what it makes: for the thread on which a program starts, never for one that the event
     * thread may wait for.
     *
     * @throws IllegalStateException if the work failed, with its reason
     */
    public static <T> T get(Supplier<T> work) {
        CompletableFuture<T> done = new CompletableFuture<>();
        EventQueue.invokeLater(() -> {
            try {
                done.complete(work.get());
            } catch (RuntimeException | Error fault) {
                done.completeExceptionally(fault);
            }
        });
        try {
            return done.get();
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new IllegalStateException("interrupted while the window opens", e);
        } catch (ExecutionException fault) {
            Throwable cause = Objects.requireNonNull(fault.getCause(), "cause");
            throw new IllegalStateException("the window cannot be opened: " + cause.getMessage(), cause);
        }
    }

    /** The press of a key or the pointer that the event thread handles now; empty where it does something else, and on other threads. */
    public static Optional<InputEvent> handledInput() {
        return EventQueue.getCurrentEvent() instanceof InputEvent press ? Optional.of(press) : Optional.empty();
    }

    /** Whether the caller is on the event thread. */
    public static boolean isCurrent() {
        return EventQueue.isDispatchThread();
    }

    /**
     * Makes sure that the caller is on the event thread.
     *
     * @throws IllegalStateException if it is not
     */
    public static void require() {
        if (!isCurrent()) {
            throw new IllegalStateException(
                    "a view was touched on the thread " + Thread.currentThread().getName()
                            + "; views live on the event thread, hand it over with EventThread.later");
        }
    }
}
