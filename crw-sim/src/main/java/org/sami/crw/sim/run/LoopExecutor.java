package org.sami.crw.sim.run;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Objects;
import java.util.concurrent.Executor;

/**
 * Tasks of the run's only thread, shared by engine and handlers; all are done before simulated time advances. First in, first out: what handlers post
 * keeps the order of their activations.
 */
public final class LoopExecutor implements Executor {
    private final Deque<Runnable> waiting = new ArrayDeque<>();

    @Override
    public void execute(Runnable command) {
        waiting.add(Objects.requireNonNull(command, "command"));
    }

    /** Runs all waiting tasks and those that they add. */
    public void drain() {
        for (Runnable next = waiting.poll(); next != null; next = waiting.poll()) {
            next.run();
        }
    }
}
