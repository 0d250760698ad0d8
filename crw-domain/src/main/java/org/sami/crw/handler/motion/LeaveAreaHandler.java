package org.sami.crw.handler.motion;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.sami.crw.handler.activation.ActivationFields;
import org.sami.crw.handler.activation.Addressee;
import org.sami.crw.proxy.ProxyRegistry;
import org.sami.crw.proxy.status.BoatPose;
import org.sami.crw.service.path.WayOut;
import org.sami.spn.host.ActivationHandler;
import org.sami.spn.host.HandlerContext;
import org.sami.spn.protocol.Activation;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPoint;

/**
 * Proxy Leave Area: each boat that is in the area drives out of it, along what it has left of the path that it drives or that was taken from it last;
 * where that does not lead out, across the nearest edge. A boat that is outside completes at once.
 */
public final class LeaveAreaHandler implements ActivationHandler {
    public static final String TYPE = "ProxyLeaveArea";
    private static final String AREA = "area";

    private final ProxyRegistry boats;
    private final MotionCommands motion;
    private final BoatErrors errors;

    public LeaveAreaHandler(ProxyRegistry boats, MotionCommands motion, BoatErrors errors) {
        this.boats = boats;
        this.motion = motion;
        this.errors = errors;
    }

    @Override
    public void handle(Activation activation, HandlerContext context) {
        if (!(ActivationFields.required(activation, AREA) instanceof GeoArea area)) {
            throw new IllegalArgumentException("\"" + AREA + "\" is no area: " + activation.value(AREA));
        }
        WayOut out = new WayOut(area);
        WayLimits limits = context.query(view -> WayLimits.of(activation, view));
        List<Move> moves = new ArrayList<>();
        List<Addressee> nowhere = new ArrayList<>();
        for (Addressee addressee : Addressee.of(activation, context)) {
            Optional<GeoPoint> from = boats.find(addressee.boat())
                    .flatMap(boat -> boat.status().pose())
                    .map(BoatPose::position);
            if (from.isPresent()) {
                moves.add(GotoPointHandler.go(
                        activation, addressee, way(out, addressee.boat(), from.get(), limits), false));
            } else {
                nowhere.add(addressee);
            }
        }
        motion.send(activation, context, moves);
        nowhere.forEach(one -> motion.refuse(activation, context, one, "its position is unknown"));
    }

    private List<GeoPoint> way(WayOut out, String boat, GeoPoint from, WayLimits limits) {
        if (!out.isInside(from)) {
            return List.of();
        }
        return out.along(from, motion.leftPaths().of(boat))
                .orElseGet(() -> List.of(
                        out.acrossNearestEdge(from, limits.water(Optional.of(from), List.of(from), errors.of(boat)))));
    }
}
