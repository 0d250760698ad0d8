package org.sami.crw.session;

import java.util.List;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.Executor;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import org.sami.session.api.RefusedException;

/**
 * Results that callers of a session wait for. They arrive on the front's executor, never on the engine's or the fleet's thread, so
 * that whatever a caller does with them holds up neither; those that are open when the session closes fail. Safe for use by several
 * threads.
 */
final class Replies {
    private final Executor front;
    private final AtomicLong made = new AtomicLong();
    private final Map<Long, Reply<?>> open = new ConcurrentHashMap<>();
    private volatile boolean closed;

    Replies(Executor front) {
        this.front = front;
    }

    /** A result that may still be open. */
    final class Reply<T> {
        private final long id = made.incrementAndGet();
        private final CompletableFuture<T> future = new CompletableFuture<>();

        CompletionStage<T> stage() {
            return future;
        }

        void complete(@Nullable T value) {
            arrive(() -> future.complete(value));
        }

        void fail(Throwable why) {
            arrive(() -> future.completeExceptionally(why));
        }

        private void arrive(Runnable arrival) {
            if (open.remove(id) != null) {
                try {
                    front.execute(arrival);
                } catch (RejectedExecutionException ended) {
                    arrival.run();
                }
            }
        }
    }

    /** A result that is not there yet. */
    <T> Reply<T> open() {
        Reply<T> reply = new Reply<>();
        open.put(reply.id, reply);
        if (closed) {
            reply.fail(closedSession());
        }
        return reply;
    }

    private static RefusedException closedSession() {
        return new RefusedException("the session is closed");
    }

    /** Has something done elsewhere and gives what comes of it. */
    <T> CompletionStage<T> on(Executor executor, Supplier<T> work) {
        Reply<T> reply = open();
        Runnable doing = () -> {
            try {
                reply.complete(work.get());
            } catch (RuntimeException fault) {
                reply.fail(fault);
            } catch (Error fault) {
                reply.fail(new RefusedException("it could not be done: " + fault)); // nobody waits for ever
                throw fault;
            }
        };
        try {
            executor.execute(doing);
        } catch (RejectedExecutionException ended) {
            reply.fail(closedSession());
        }
        return reply.stage();
    }

    /** Passes on a result that arrives elsewhere. */
    <T> CompletionStage<T> of(CompletionStage<T> result) {
        Reply<T> reply = open();
        result.whenComplete((value, fault) -> {
            if (fault == null) {
                reply.complete(value);
            } else {
                reply.fail(fault);
            }
        });
        return reply.stage();
    }

    /** Nothing arrives any more: what is open fails. */
    void close() {
        closed = true;
        List.copyOf(open.values()).forEach(reply -> reply.fail(closedSession()));
    }
}
