package org.sami.crw.handler;

import java.util.ArrayList;
import java.util.List;
import org.sami.spn.host.ActivationHandler;
import org.sami.spn.host.HandlerContext;
import org.sami.spn.protocol.Activation;
import org.sami.spn.value.GeoPoint;

/**
 * Proxy Goto Lat Lon: all boats go straight to one location. Where the location is read from tasks, each boat goes to those of its
 * tasks that entered, in their order, and completes at the last.
 */
final class GotoLatLonHandler implements ActivationHandler {
    static final String TYPE = "ProxyGotoLatLon";
    private static final String LOCATION = "location";

    private final MotionCommands motion;

    GotoLatLonHandler(MotionCommands motion) {
        this.motion = motion;
    }

    @Override
    public void handle(Activation activation, HandlerContext context) {
        List<Move> moves = new ArrayList<>();
        for (Addressee addressee : Addressee.of(activation, context)) {
            List<GeoPoint> points = addressee.values(activation, LOCATION).stream()
                    .map(value -> ActivationFields.point(value, LOCATION))
                    .toList();
            if (points.isEmpty()) {
                ActivationFields.required(activation, LOCATION);
            }
            moves.add(GotoPointHandler.go(activation, addressee, points, false));
        }
        motion.send(activation, context, moves);
    }
}
