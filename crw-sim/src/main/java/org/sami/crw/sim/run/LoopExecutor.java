package org.sami.crw.sim.run;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Objects;
import java.util.concurrent.Executor;

/**
 * Work that waits for the run's one thread: engine and handlers share it, and all of it is done before simulated time
 * goes on. First in, first out, so that what handlers post keeps the order of their activations.
 */
final class LoopExecutor implements Executor {
    private final Deque<Runnable> waiting = new ArrayDeque<>();

    @Override
    public void execute(Runnable command) {
        waiting.add(Objects.requireNonNull(command, "command"));
    }

    /** Does everything that waits, and what that gives rise to. */
    void drain() {
        for (Runnable next = waiting.poll(); next != null; next = waiting.poll()) {
            next.run();
        }
    }
}
