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
        var unused = asked.whenComplete((value, thrown) -> thread.execute(() -> Optional.ofNullable(thrown)
                .ifPresentOrElse(why -> fault.accept(words(why)), () -> result.accept(value))));
    }

    private static String words(Throwable thrown) {
        Throwable cause = Optional.ofNullable(thrown.getCause()).orElse(thrown);
        return Optional.ofNullable(cause.getMessage()).orElse(cause.toString());
    }
}
