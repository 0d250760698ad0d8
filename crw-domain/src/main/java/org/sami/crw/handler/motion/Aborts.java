package org.sami.crw.handler.motion;

import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import org.sami.crw.proxy.BoatProxy;
import org.sami.crw.proxy.ProxyCommands;
import org.sami.crw.proxy.ProxyRegistry;
import org.sami.crw.proxy.command.BoatCommand;

/**
 * Takes from a boat what missions have for it, wherever that is: in the boat's queue, kept back until the boat says where it is or the operator answers, or
 * among the moves that come later. For the fleet's thread.
 */
public final class Aborts {
    private final ProxyRegistry boats;
    private final MotionCommands motion;
    private final List<LaterMoves> later;

    public Aborts(ProxyRegistry boats, MotionCommands motion, List<LaterMoves> later) {
        this.boats = boats;
        this.motion = motion;
        this.later = List.copyOf(later);
    }

    /** The missions that have something for a boat that is not in its queue yet. */
    Set<Long> waiting(String boat) {
        Set<Long> missions = new HashSet<>(motion.held(boat));
        later.forEach(moves -> missions.addAll(moves.missions(boat)));
        return missions;
    }

    /** The missions that a boat carries out now: that of its command, or those whose next move for it comes as soon as it is known. */
    Set<Long> begun(String boat) {
        Optional<Long> current = boats.find(boat)
                .map(BoatProxy::commands)
                .flatMap(ProxyCommands::current)
                .filter(command -> !ChargeReturns.isOne(command)) // no mission's
                .map(BoatCommand::mission);
        return current.map(Set::of)
                .orElseGet(() -> later.stream()
                        .flatMap(moves -> moves.begunMissions(boat).stream())
                        .collect(Collectors.toSet()));
    }

    /** Takes back what a mission has for a boat, as it asks itself: nobody is answered. */
    void withdraw(long mission, String boat) {
        withdrawLater(
                mission,
                boat,
                Optional.empty()); // first, so that none of them is sent when the boat has nothing to do any longer
        motion.withdraw(mission, List.of(boat));
    }

    /** The same at another mission's request; a transition that waits receives the failure. */
    void abort(long mission, String boat, String reason) {
        withdrawLater(mission, boat, Optional.of(reason));
        motion.abort(mission, boat, reason);
    }

    /** Stops a boat; all that any mission has for it fails. */
    void stop(String boat, String reason) {
        waiting(boat).forEach(mission -> {
            motion.abortHeld(mission, boat, reason);
            withdrawLater(mission, boat, Optional.of(reason));
        });
        boats.find(boat).ifPresent(known -> known.abort(reason));
    }

    private void withdrawLater(long mission, String boat, Optional<String> why) {
        later.forEach(moves -> moves.withdraw(mission, List.of(boat), why, motion));
    }
}
