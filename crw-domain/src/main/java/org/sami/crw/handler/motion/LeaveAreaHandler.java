package org.sami.crw.handler.motion;

import java.util.List;
import java.util.Optional;
import org.sami.crw.handler.activation.ActivationFields;
import org.sami.crw.handler.activation.Addressee;
import org.sami.crw.service.path.WayOut;
import org.sami.spn.host.ActivationHandler;
import org.sami.spn.host.HandlerContext;
import org.sami.spn.protocol.Activation;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPoint;

/**
 * Proxy Leave Area: each boat that is in the area drives out of it, along what it has left of the path that it drives or that was taken from it last;
 * where that does not lead out, across the nearest edge. A boat that is outside completes at once; one that has not said where it is goes once it has.
 */
public final class LeaveAreaHandler implements ActivationHandler {
    public static final String TYPE = "ProxyLeaveArea";
    private static final String AREA = "area";

    private final MotionCommands motion;
    private final BoatErrors errors;

    public LeaveAreaHandler(MotionCommands motion, BoatErrors errors) {
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
        List<Move> moves = Addressee.of(activation, context).stream()
                .map(one -> Move.fromHere(activation, one, here -> way(out, one.boat(), here, limits)))
                .toList();
        motion.send(activation, context, moves);
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
