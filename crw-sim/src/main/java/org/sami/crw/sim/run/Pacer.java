package org.sami.crw.sim.run;

/** Keeps the simulated time from running ahead of the wall clock. The only place of a run that may wait. */
public interface Pacer {
    /** Never waits. */
    Pacer UNPACED = new Pacer() {
        @Override
        public void start(long virtualMillis) {
            // Nothing is measured.
        }

        @Override
        public void awaitTurn(long virtualMillis) {
            // It is always time.
        }
    };

    /** From now on time is paced; it is this moment in the simulated world. */
    void start(long virtualMillis);

    /** Waits until the wall clock has come to a moment of the simulated world; returns early when interrupted. */
    void awaitTurn(long virtualMillis);
}
