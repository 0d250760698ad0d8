package org.sami.crw.sim.run;

import java.io.IOException;
import java.util.OptionalLong;
import java.util.function.Supplier;
import org.sami.spn.host.InputJournal;
import org.sami.spn.host.NoJournal;

/** The journal of a run in process: the engine's inputs, and marks with which a resumed run is compared. For the run's thread. */
public interface RunJournal {
    /** Takes the inputs of the engine's host. */
    InputJournal inputs();

    /**
     * Marks a moment of the world: after the last input, at a time.
     *
     * @param fingerprint gives a hash of the boats' true state
     * @throws IOException where it cannot be written, or is not what was written before
     */
    void mark(long atMillis, Supplier<String> fingerprint) throws IOException;

    /** The run stops before its mission is over; a resume needs to know the time. */
    void stopped(long atMillis) throws IOException;

    /** Whether the run still repeats what an earlier process did. */
    boolean isCatchingUp();

    /** Index of the last entry that an earlier process wrote; empty for a run from its start. */
    OptionalLong resumedFrom();

    /**
     * The mission is over.
     *
     * @throws IOException if it was not when an earlier process came here
     */
    void over() throws IOException;

    /** A journal that nobody reads. */
    static RunJournal none() {
        return new RunJournal() {
            private final InputJournal inputs = new NoJournal();

            @Override
            public InputJournal inputs() {
                return inputs;
            }

            @Override
            public void mark(long atMillis, Supplier<String> fingerprint) {
                // Nobody will compare it.
            }

            @Override
            public void stopped(long atMillis) {
                // Nobody takes it up.
            }

            @Override
            public boolean isCatchingUp() {
                return false;
            }

            @Override
            public OptionalLong resumedFrom() {
                return OptionalLong.empty();
            }

            @Override
            public void over() {
                // There is nothing to compare it with.
            }
        };
    }
}
