package org.sami.spn.host;

import java.util.List;
import java.util.function.Function;
import org.sami.spn.engine.EngineView;
import org.sami.spn.protocol.Input;

/** What a handler may use of its host. All methods can be called from any thread. */
public interface HandlerContext {
    /** Posts inputs as one batch: nothing comes between them. */
    void post(List<Input> inputs);

    /** Posts one input. */
    default void post(Input input) {
        post(List.of(input));
    }

    /** Asks the engine's state; waits at most until the batch that is being processed has left. */
    <T> T query(Function<EngineView, T> question);

    /** The session's clock, in milliseconds. */
    long nowMillis();

    /** Whether this activation was delivered before: before a crash, or before somebody ordered it again. */
    boolean redelivered();

    /** Whether somebody ordered that it is delivered again ({@link EngineHost#redeliver}); false after a crash. */
    default boolean orderedAgain() {
        return false;
    }
}
