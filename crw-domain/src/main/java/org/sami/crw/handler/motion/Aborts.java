package org.sami.crw.handler.motion;

import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.sami.crw.proxy.ProxyRegistry;

/**
 * Takes from a boat what missions have for it, wherever that is: in the boat's queue, kept back until the boat says where it is or the operator answers, or
 * still computed. For the fleet's thread.
 */
public final class Aborts {
    private final ProxyRegistry boats;
    private final MotionCommands motion;
    private final ComputedMoves computed;

    public Aborts(ProxyRegistry boats, MotionCommands motion, ComputedMoves computed) {
        this.boats = boats;
        this.motion = motion;
        this.computed = computed;
    }

    /** The missions that have something for a boat that is not in its queue yet. */
    Set<Long> waiting(String boat) {
        Set<Long> missions = new HashSet<>(motion.held(boat));
        missions.addAll(computed.missions(boat));
        return missions;
    }

    /** Takes back what a mission has for a boat, as it asks itself: nobody is answered. */
    void withdraw(long mission, String boat) {
        motion.withdraw(mission, List.of(boat));
        computed.withdraw(mission, List.of(boat), motion::takeBack);
    }

    /** The same at another mission's request; a transition that waits receives the failure. */
    void abort(long mission, String boat, String reason) {
        motion.abort(mission, boat, reason);
        failComputed(mission, boat, reason);
    }

    /** Stops a boat; all that any mission has for it fails. */
    void stop(String boat, String reason) {
        waiting(boat).forEach(mission -> {
            motion.abortHeld(mission, boat, reason);
            failComputed(mission, boat, reason);
        });
        boats.find(boat).ifPresent(known -> known.abort(reason));
    }

    private void failComputed(long mission, String boat, String reason) {
        computed.withdraw(mission, List.of(boat), (activation, named) -> motion.takeBack(activation, named, reason));
    }
}
