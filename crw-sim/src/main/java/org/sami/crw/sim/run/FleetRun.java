package org.sami.crw.sim.run;

import org.sami.crw.sim.run.record.RunProgress;
import org.sami.crw.sim.run.record.RunRecords;

/** A run as the fleet sees it that takes part in it: what it begins, and what it repeats while time passes. For the engine's thread. */
public interface FleetRun {
    /** What is written down of it. */
    RunRecords records();

    /** What starts its mission and knows when it is over. */
    RunLifecycle lifecycle();

    /** From now on everything that happens in the session is part of the run. */
    void connect();

    /**
     * Looks at the boats from now on.
     *
     * @param afterLook is done after each look
     */
    void followBoats(Runnable afterLook);

    /** Ends the run from now on where nothing can happen in it any longer. */
    void lookForStalls();

    /** Does something every so often, from now on. */
    void repeat(long everyMillis, Runnable action);

    /** How far it is. */
    RunProgress progress(String phase);
}
