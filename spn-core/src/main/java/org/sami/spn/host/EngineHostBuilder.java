package org.sami.spn.host;

import java.util.Objects;
import java.util.concurrent.Executor;
import org.jspecify.annotations.Nullable;
import org.sami.spn.engine.Engine;
import org.sami.spn.engine.EngineState;

/** Puts a host together: an engine with its state, an executor and a clock are required. */
public final class EngineHostBuilder {
    private final EngineFunction engine;
    private InputJournal journal = new MemoryJournal();
    private @Nullable HostClock clock;
    private @Nullable Executor executor;
    private int batchLimit = 1024;
    private long slowListenerMillis = 50;
    private long journalRetryMillis = Long.MAX_VALUE;

    private EngineHostBuilder(EngineFunction engine) {
        this.engine = Objects.requireNonNull(engine, "engine");
    }

    /** A host of anything that behaves as an engine, to be put together. */
    public static EngineHostBuilder of(EngineFunction engine) {
        return new EngineHostBuilder(engine);
    }

    /**
     * A host to be put together.
     *
     * @param state the state to go on from; belongs to the host from now on
     */
    public static EngineHostBuilder of(Engine engine, EngineState state) {
        return of(new EngineWithState(engine, state));
    }

    /** Where inputs are written; at its end stands the state that is hosted. Without it: memory. */
    public EngineHostBuilder journal(InputJournal value) {
        journal = Objects.requireNonNull(value, "journal");
        return this;
    }

    /** The session's time; at or after the journal's last. */
    public EngineHostBuilder clock(HostClock value) {
        clock = Objects.requireNonNull(value, "clock");
        return this;
    }

    /** The engine's thread: runs what it is given one after another. */
    public EngineHostBuilder executor(Executor value) {
        executor = Objects.requireNonNull(value, "executor");
        return this;
    }

    /** How many inputs one batch takes at most, if its last posting is not counted; 1,024 by default. */
    public EngineHostBuilder batchLimit(int value) {
        if (value < 1) {
            throw new IllegalArgumentException("a batch takes at least 1 input, not " + value);
        }
        batchLimit = value;
        return this;
    }

    /** From how many milliseconds on a listener's call is reported as slow; 50 by default. */
    public EngineHostBuilder slowListenerMillis(long value) {
        slowListenerMillis = value;
        return this;
    }

    /** How long it waits for a journal that cannot be written before it stops; without limit by default. */
    public EngineHostBuilder journalRetryMillis(long value) {
        journalRetryMillis = value;
        return this;
    }

    /**
     * The host, working.
     *
     * @throws IllegalStateException if the executor or the clock is missing
     */
    public EngineHost build() {
        if (executor == null || clock == null) {
            throw new IllegalStateException("a host needs an executor and a clock");
        }
        return new EngineHost(
                engine, journal, clock, executor, new HostLimits(batchLimit, slowListenerMillis, journalRetryMillis));
    }
}
