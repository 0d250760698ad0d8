package org.sami.crw.handler.motion;

import java.util.ArrayList;
import java.util.List;
import org.sami.crw.handler.activation.ActivationFields;
import org.sami.crw.handler.activation.Addressee;
import org.sami.spn.host.ActivationHandler;
import org.sami.spn.host.HandlerContext;
import org.sami.spn.protocol.Activation;
import org.sami.spn.value.GeoPoint;

/**
 * Proxy Goto Lat Lon: all boats go straight to one location. Where the location is read from tasks, each boat goes to those of its
 * tasks that entered, in their order, and completes at the last.
 */
public final class GotoLatLonHandler implements ActivationHandler {
    public static final String TYPE = "ProxyGotoLatLon";
    private static final String LOCATION = "location";

    private final MotionCommands motion;

    public GotoLatLonHandler(MotionCommands motion) {
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
