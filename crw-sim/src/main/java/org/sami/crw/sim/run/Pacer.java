package org.sami.crw.sim.run;

/** Keeps simulated time from running ahead of the wall clock. The only part of a run that may wait. */
public interface Pacer {
    /** Never waits. */
    Pacer UNPACED = new Pacer() {
        @Override
        public void start(long virtualMillis) {
            // Nothing is measured.
        }

        @Override
        public void awaitTurn(long virtualMillis) {
            // Never late.
        }
    };

    /** Starts pacing at this moment of simulated time. */
    void start(long virtualMillis);

    /** Waits until the wall clock reaches a moment of simulated time; returns early when interrupted. */
    void awaitTurn(long virtualMillis);
}
