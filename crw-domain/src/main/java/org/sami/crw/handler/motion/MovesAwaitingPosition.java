package org.sami.crw.handler.motion;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.Stream;
import org.sami.crw.fleet.FleetEvent;
import org.sami.crw.proxy.BoatProxy;
import org.sami.crw.proxy.ProxyRegistry;
import org.sami.crw.proxy.status.BoatPose;
import org.sami.spn.host.HandlerContext;
import org.sami.spn.protocol.Activation;
import org.sami.spn.value.GeoPoint;

/**
 * Moves of boats that have not said where they are: their ways cannot be checked, so they wait for the boats' first positions. For the fleet's
 * thread.
 */
final class MovesAwaitingPosition {
    private final ProxyRegistry boats;
    private final List<HeldMove> waiting = new ArrayList<>();

    MovesAwaitingPosition(ProxyRegistry boats) {
        this.boats = boats;
    }

    /** Keeps the moves that wait; the others are returned, those that go from where the boat is with their ways. */
    List<Move> hold(Activation activation, HandlerContext context, List<Move> moves) {
        List<Move> others = new ArrayList<>();
        for (Move move : moves) {
            Optional<BoatProxy> boat = boats.find(move.addressee().boat());
            Optional<GeoPoint> here = position(boat);
            boolean needsPosition = move.wayFromHere().isPresent()
                    || !move.command().unvisitedPoints().isEmpty();
            boolean waits = needsPosition && boat.isPresent() && here.isEmpty();
            if (waits) {
                waiting.add(new HeldMove(activation, context, move));
                boat.get().commands().awaitPosition(true);
            } else {
                others.add(here.map(at -> move.from(at, activation)).orElse(move));
            }
        }
        return others;
    }

    private static Optional<GeoPoint> position(Optional<BoatProxy> boat) {
        return boat.flatMap(known -> known.status().pose()).map(BoatPose::position);
    }

    private HeldMove located(HeldMove one) {
        return position(boats.find(one.boat()))
                .map(here ->
                        new HeldMove(one.activation(), one.context(), one.move().from(here, one.activation())))
                .orElse(one);
    }

    /** Gives the moves of a boat that need not wait any longer: it has said where it is, or has been given up. */
    List<HeldMove> released(FleetEvent event) {
        boolean isGone = event instanceof FleetEvent.Retired || event instanceof FleetEvent.Removed;
        boolean isLocated = event instanceof FleetEvent.OfStatus known
                && known.status().pose().isPresent();
        if (waiting.isEmpty() || !(isGone || isLocated)) {
            return List.of();
        }
        List<HeldMove> released =
                waiting.stream().filter(one -> one.boat().equals(event.boat())).toList();
        waiting.removeAll(released);
        tellBoats(released);
        return released.stream().map(this::located).toList();
    }

    /** The moves that wait. */
    Stream<HeldMove> moves() {
        return waiting.stream();
    }

    /** Replaces each move by what is left of it; returns those of which nothing is. */
    List<HeldMove> reduce(Function<HeldMove, Optional<HeldMove>> left) {
        List<HeldMove> taken =
                waiting.stream().filter(one -> left.apply(one).isEmpty()).toList();
        waiting.removeAll(taken);
        waiting.replaceAll(one -> left.apply(one).orElse(one));
        tellBoats(taken);
        return taken;
    }

    private void tellBoats(List<HeldMove> gone) {
        for (HeldMove one : gone) {
            boolean waits = waiting.stream().anyMatch(other -> other.boat().equals(one.boat()));
            boats.find(one.boat()).ifPresent(boat -> boat.commands().awaitPosition(waits));
        }
    }
}
