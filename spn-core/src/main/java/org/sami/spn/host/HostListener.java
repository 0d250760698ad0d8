package org.sami.spn.host;

import java.util.List;
import org.sami.spn.engine.EngineView;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Input;

/** Watches a host. What it throws is logged and reaches neither the engine nor other listeners. */
@FunctionalInterface
public interface HostListener {
    /**
     * One input was processed and is durable. Called on the engine's thread, in order; must be quick.
     *
     * @param index index of the input in the journal, from 1
     * @param atMillis the session's time of the input
     * @param view the state after it and after the other inputs of its batch (an exact one needs batches of one input);
     *     not to be kept
     */
    void onStep(long index, long atMillis, Input input, List<Effect> effects, EngineView view);

    /**
     * The journal cannot be written: the host waits with all that follows, and tries again. Told again where the reason has become another one.
     *
     * @param status why it waits
     */
    default void onWaiting(HostStatus status) {}

    /** The journal is written again: the host goes on where it waited. */
    default void onGoingOn() {}

    /**
     * The host stopped by a fault: nothing will follow. On the engine's thread, or the thread that found the fault.
     *
     * @param status why it stopped
     */
    default void onFailed(HostStatus status) {}
}
