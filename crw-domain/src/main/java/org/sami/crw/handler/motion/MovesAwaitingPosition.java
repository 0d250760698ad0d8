package org.sami.crw.handler.motion;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.sami.crw.decision.AskedActivation;
import org.sami.crw.fleet.FleetEvent;
import org.sami.crw.proxy.BoatProxy;
import org.sami.crw.proxy.ProxyRegistry;
import org.sami.spn.host.HandlerContext;
import org.sami.spn.protocol.Activation;

/**
 * Moves of boats that have not said where they are: their ways cannot be checked, so they wait for the boats' first positions. A base that goes on
 * with a mission does not check again what was sent before, unless the operator has not answered yet. For the fleet's thread.
 */
final class MovesAwaitingPosition {
    private final ProxyRegistry boats;
    private final List<Waiting> waiting = new ArrayList<>();

    /** A move, and who asked for it. */
    record Waiting(Activation activation, HandlerContext context, Move move) {
        String boat() {
            return move.addressee().boat();
        }
    }

    MovesAwaitingPosition(ProxyRegistry boats) {
        this.boats = boats;
    }

    /** Keeps the moves that wait; the others are returned. */
    List<Move> hold(Activation activation, HandlerContext context, List<Move> moves) {
        List<Move> others = new ArrayList<>();
        boolean checked = context.redelivered() && !isAskedAbout(activation, context);
        for (Move move : moves) {
            Optional<BoatProxy> boat = boats.find(move.addressee().boat());
            boolean waits = !checked
                    && !move.command().unvisitedPoints().isEmpty()
                    && boat.isPresent()
                    && boat.get().status().pose().isEmpty();
            if (waits) {
                waiting.add(new Waiting(activation, context, move));
                boat.get().commands().awaitPosition(true);
            } else {
                others.add(move);
            }
        }
        return others;
    }

    private static boolean isAskedAbout(Activation activation, HandlerContext context) {
        String about = AskedActivation.of(activation).subject();
        return context.query(view -> view.decisions().stream()
                .anyMatch(decision ->
                        view.subject(decision.id()).filter(about::equals).isPresent()));
    }

    /** Gives the moves of a boat that need not wait any longer: it has said where it is, or has been given up. */
    List<Waiting> released(FleetEvent event) {
        boolean isGone = event instanceof FleetEvent.Retired || event instanceof FleetEvent.Removed;
        boolean isLocated = event instanceof FleetEvent.OfStatus known
                && known.status().pose().isPresent();
        if (waiting.isEmpty() || !(isGone || isLocated)) {
            return List.of();
        }
        List<Waiting> released =
                waiting.stream().filter(one -> one.boat().equals(event.boat())).toList();
        waiting.removeAll(released);
        tellBoats(released);
        return released;
    }

    /** Takes back what a mission wants of boats; no boats named = of all. */
    void withdraw(long mission, List<String> named) {
        List<Waiting> withdrawn = waiting.stream()
                .filter(one -> one.activation().mission() == mission)
                .filter(one -> named.isEmpty() || named.contains(one.boat()))
                .toList();
        waiting.removeAll(withdrawn);
        tellBoats(withdrawn);
    }

    private void tellBoats(List<Waiting> gone) {
        for (Waiting one : gone) {
            boolean waits = waiting.stream().anyMatch(other -> other.boat().equals(one.boat()));
            boats.find(one.boat()).ifPresent(boat -> boat.commands().awaitPosition(waits));
        }
    }
}
