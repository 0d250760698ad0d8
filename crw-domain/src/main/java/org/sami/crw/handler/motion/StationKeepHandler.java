package org.sami.crw.handler.motion;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.sami.crw.event.ProxyMaps;
import org.sami.crw.handler.activation.ActivationFields;
import org.sami.crw.handler.activation.Addressee;
import org.sami.crw.proxy.command.KeepStation;
import org.sami.spn.host.ActivationHandler;
import org.sami.spn.host.HandlerContext;
import org.sami.spn.protocol.Activation;
import org.sami.spn.value.GeoPoint;

/**
 * Proxy Station Keep: each boat goes to its own point of the map and is kept there for the mission; found farther away than the radius,
 * it goes back. A boat without a point has no station, and fails. Where the mission has ended already (its end place asks for
 * it), the boats go to their points and are not kept. A message warns the operator of points that are too near to one another ({@link NearPlaces}).
 */
public final class StationKeepHandler implements ActivationHandler {
    public static final String TYPE = "ProxyStationKeep";
    private static final String POINTS = "points";
    private static final String RADIUS = "radius";

    private final MotionCommands motion;
    private final NearPlaces near;

    public StationKeepHandler(MotionCommands motion, NearPlaces near) {
        this.motion = motion;
        this.near = near;
    }

    @Override
    public void handle(Activation activation, HandlerContext context) {
        Map<String, GeoPoint> points = ProxyMaps.read(ActivationFields.required(activation, POINTS), GeoPoint.class);
        double radiusM = ActivationFields.metres(activation, RADIUS);
        boolean running = Move.mayBlock(activation, context);
        List<Move> moves = new ArrayList<>();
        List<String> without = new ArrayList<>();
        for (Addressee addressee : Addressee.of(activation, context)) {
            GeoPoint point = points.get(addressee.boat());
            if (point == null) {
                without.add(addressee.boat());
            } else if (running) {
                moves.add(station(activation, addressee, point, radiusM));
            } else {
                moves.add(GotoPointHandler.go(activation, addressee, List.of(point), false));
            }
        }
        if (running) {
            near.look(activation, context, "Station keeping", points);
        }
        motion.send(activation, context, moves);
        if (!without.isEmpty()) {
            throw new IllegalArgumentException("there is no station for " + String.join(", ", without));
        }
    }

    private static Move station(Activation activation, Addressee addressee, GeoPoint point, double radiusM) {
        KeepStation command = new KeepStation(
                Move.commandId(activation, addressee),
                activation.mission(),
                activation.id(),
                point,
                radiusM,
                activation.priority(),
                true);
        return new Move(addressee, command, Optional.empty(), Reply.STATION_IF_AWAITED);
    }
}
