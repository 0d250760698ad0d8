package org.sami.crw.handler.motion;

import java.util.List;
import java.util.Set;
import java.util.function.BiConsumer;

/** Moves of boats that services still compute, and that will be sent then. For the fleet's thread. */
public interface ComputedMoves {
    /** The missions for which moves of a boat are computed. */
    Set<Long> missions(String boat);

    /**
     * Takes back what a mission's computations will have boats do; no boats named = all.
     *
     * @param takeBack is given each activation whose commands are not to be sent, with the boats for which they are not
     */
    void withdraw(long mission, List<String> named, BiConsumer<Long, List<String>> takeBack);
}
