package org.sami.crw.mavlink;

import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.Executor;
import java.util.function.Consumer;

/** Hands results of requests to a vehicle over to the gateway's thread. */
final class Results {
    private Results() {}

    /** Calls {@code result} with the value on that thread; calls {@code fault} with the reason, in words, where the request failed. */
    static <T> void when(
            CompletableFuture<T> asked, Executor thread, Consumer<? super T> result, Consumer<String> fault) {
        whenOrFailed(asked, thread, result, failed -> fault.accept(words(failed)));
    }

    /** The same, but calls {@code fault} with what has failed, such as a refusal by the vehicle. */
    static <T> void whenOrFailed(
            CompletableFuture<T> asked, Executor thread, Consumer<? super T> result, Consumer<Throwable> fault) {
        var unused = asked.whenComplete((value, thrown) -> thread.execute(() -> Optional.ofNullable(thrown)
                .map(failed -> Optional.ofNullable(failed.getCause()).orElse(failed))
                .ifPresentOrElse(fault, () -> result.accept(value))));
    }

    /** Why a request failed, in words. */
    static String words(Throwable failed) {
        return Optional.ofNullable(failed.getMessage()).orElse(failed.toString());
    }
}
