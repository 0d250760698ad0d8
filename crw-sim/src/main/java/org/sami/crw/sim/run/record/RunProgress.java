package org.sami.crw.sim.run.record;

import java.util.Objects;

/**
 * The progress of a run.
 *
 * @param phase a word: {@code running}, or {@code catching up} while a journal is gone through again
 * @param leastBatteryPercent of the boat with the least charge
 */
public record RunProgress(
        String phase,
        long simulatedMillis,
        int visited,
        int locations,
        int openDecisions,
        long firings,
        double leastBatteryPercent) {
    /** The phase of a run that does not repeat its journal. */
    public static final String RUNNING = "running";

    public RunProgress {
        Objects.requireNonNull(phase, "phase");
    }
}
