package org.sami.mavlink.mission;

import java.util.Optional;

/** One exchange with a vehicle about a list that it holds. Only one may run with a vehicle at a time, as the protocol cannot tell them apart. Used by one thread. */
interface ListTransfer {
    /** Sends for the first time. */
    void begin(long nowMs);

    /** Sends again where an answer is overdue. */
    void tick(long nowMs);

    /** Takes what the vehicle sent; anything that is no part of this transfer changes nothing. */
    void take(Object message, long nowMs);

    /** Whether it has ended, well or not. */
    boolean isOver();

    /** Why it failed, with words for people, a {@link ListRefusedException} where the vehicle refused; empty where it did not fail. */
    Optional<IllegalStateException> failure();
}
