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
            String boat = move.addressee().boat();
            Optional<GeoPoint> from =
                    boats.find(boat).flatMap(proxy -> proxy.status().pose()).map(BoatPose::position);
            List<GeoPoint> points = move.command().unvisitedPoints();
            Optional<Water> water = points.isEmpty() ? Optional.empty() : limits.water(from, points, errors.of(boat));
            limited.add(water.map(one -> move.with(move.command().in(one))).orElse(move));
            if (from.isPresent() && water.isPresent()) {
                tellOfDanger(activation, context, move, from.get(), points, water.get());
            }
        }
        return limited;
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
