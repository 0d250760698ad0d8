package org.sami.crw.handler.motion;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.sami.crw.event.ProxyMaps;
import org.sami.crw.handler.activation.Addressee;
import org.sami.crw.proxy.command.FollowPath;
import org.sami.spn.host.ActivationHandler;
import org.sami.spn.host.HandlerContext;
import org.sami.spn.protocol.Activation;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.Value;

/**
 * Proxy Goto Point, and Proxy Goto Point and Block: each boat goes straight to its own point of the map, again each time it is asked.
 * A boat without a point completes at once. With block, the boat is kept for the mission there until the mission ends (thesis 6.3.3).
 */
public final class GotoPointHandler implements ActivationHandler {
    public static final String TYPE = "ProxyGotoPoint";
    public static final String BLOCKING_TYPE = "ProxyGotoPointAndBlock";
    private static final String POINTS = "points";

    private final MotionCommands motion;
    private final boolean block;

    /** The handler of the type that blocks, or of the one that does not. */
    public GotoPointHandler(MotionCommands motion, boolean block) {
        this.block = block;
        this.motion = motion;
    }

    @Override
    public void handle(Activation activation, HandlerContext context) {
        boolean keep = block && Move.mayBlock(activation, context);
        List<Move> moves = new ArrayList<>();
        for (Addressee addressee : Addressee.of(activation, context)) {
            List<GeoPoint> points = new ArrayList<>();
            for (Value byBoat : addressee.values(activation, POINTS)) {
                Optional.ofNullable(ProxyMaps.read(byBoat, GeoPoint.class).get(addressee.boat()))
                        .ifPresent(points::add);
            }
            moves.add(go(activation, addressee, points, keep));
        }
        motion.send(activation, context, moves);
    }

    static Move go(Activation activation, Addressee addressee, List<GeoPoint> points, boolean keep) {
        FollowPath free = Move.pathOf(activation, addressee, points);
        return new Move(addressee, keep ? free.blocking() : free, Optional.empty(), Reply.WAY);
    }
}
