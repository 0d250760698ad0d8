package org.sami.crw.handler.motion;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.sami.crw.fleet.FleetEvent;
import org.sami.crw.fleet.publishing.FleetEvents;
import org.sami.crw.handler.activation.ActivationMessages;
import org.sami.crw.message.MessageSink;
import org.sami.crw.proxy.ProxyRegistry;
import org.sami.crw.proxy.status.BoatPose;
import org.sami.crw.service.reach.WayDanger;
import org.sami.crw.service.water.Water;
import org.sami.spn.host.HandlerContext;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Priority;
import org.sami.spn.value.GeoPoint;

/**
 * Has boats keep clear of what the plan avoids and in what it names as the area to stay in, on whichever way they are sent
 * (docs/services.md). Tells the operator where a boat may nevertheless come into it. For the fleet's thread.
 */
public final class ClearWays {
    private final ProxyRegistry boats;
    private final MessageSink messages;
    private final BoatErrors errors;
    private final FleetEvents events;

    public ClearWays(ProxyRegistry boats, MessageSink messages, BoatErrors errors, FleetEvents events) {
        this.boats = boats;
        this.messages = messages;
        this.errors = errors;
        this.events = events;
    }

    /** The same moves, with the water in which the boats may go. */
    List<Move> limit(Activation activation, HandlerContext context, List<Move> moves) {
        if (moves.isEmpty()) {
            return moves;
        }
        WayLimits limits = context.query(view -> WayLimits.of(activation, view));
        if (limits.avoid().isEmpty() && limits.within().isEmpty()) {
            return moves;
        }
        List<Move> limited = new ArrayList<>();
        for (Move move : moves) {
            Optional<GeoPoint> from = position(move);
            Optional<Water> water = water(limits, move);
            limited.add(in(water, move));
            if (from.isPresent() && water.isPresent()) {
                List<GeoPoint> points = move.command().unvisitedPoints();
                tellOfDanger(activation, context, move, from.get(), points, water.get());
            }
        }
        return limited;
    }

    /** The same move in the water of some limits; nobody is told of dangers. */
    Move limit(WayLimits limits, Move move) {
        return limits.avoid().isEmpty() && limits.within().isEmpty() ? move : in(water(limits, move), move);
    }

    private static Move in(Optional<Water> water, Move move) {
        return water.map(one -> move.with(move.command().in(one))).orElse(move);
    }

    private Optional<Water> water(WayLimits limits, Move move) {
        List<GeoPoint> points = move.command().unvisitedPoints();
        return points.isEmpty()
                ? Optional.empty()
                : limits.water(
                        position(move), points, errors.of(move.addressee().boat()));
    }

    private Optional<GeoPoint> position(Move move) {
        return boats.find(move.addressee().boat())
                .flatMap(proxy -> proxy.status().pose())
                .map(BoatPose::position);
    }

    /** How far boats may be off their ways. */
    BoatErrors errors() {
        return errors;
    }

    private void tellOfDanger(
            Activation activation,
            HandlerContext context,
            Move move,
            GeoPoint from,
            List<GeoPoint> points,
            Water water) {
        String boat = move.addressee().boat();
        for (WayDanger danger : WayDanger.of(from, points, water)) {
            messages.tell(ActivationMessages.of(
                    activation, context, Priority.LOW, boat + " " + danger.words(), List.of(boat)));
            events.publish(new FleetEvent.DepthAnnounced(boat, danger.insideM()));
        }
    }
}
