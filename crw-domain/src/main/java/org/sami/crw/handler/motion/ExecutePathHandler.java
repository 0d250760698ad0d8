package org.sami.crw.handler.motion;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import org.sami.crw.event.ProxyMaps;
import org.sami.crw.handler.activation.Addressee;
import org.sami.crw.proxy.command.FollowPath;
import org.sami.spn.host.ActivationHandler;
import org.sami.spn.host.HandlerContext;
import org.sami.spn.protocol.Activation;
import org.sami.spn.value.GeoPath;
import org.sami.spn.value.Value;

/**
 * Proxy Execute Path, and Proxy Execute Path and Block: each boat follows its own path of the map, from the first location that it has not visited in this mission
 * (decision 0040, docs/services.md). A boat without a path, or with nothing left of it, completes at once.
 * With block, the boat is kept for the mission until the mission ends.
 */
public final class ExecutePathHandler implements ActivationHandler {
    public static final String TYPE = "ProxyExecutePath";
    public static final String BLOCKING_TYPE = "ProxyExecutePathAndBlock";
    private static final String PATHS = "paths";

    private final MotionCommands motion;
    private final boolean block;

    /** The handler of the type that blocks, or of the one that does not. */
    public ExecutePathHandler(MotionCommands motion, boolean block) {
        this.block = block;
        this.motion = motion;
    }

    @Override
    public void handle(Activation activation, HandlerContext context) {
        List<Move> moves = new ArrayList<>();
        for (Addressee addressee : Addressee.of(activation, context)) {
            moves.add(move(activation, context, addressee, pathFor(addressee, activation), block));
        }
        motion.send(activation, context, moves);
    }

    private static GeoPath pathFor(Addressee addressee, Activation activation) {
        for (Value paths : addressee.values(activation, PATHS)) {
            Map<String, GeoPath> byBoat = ProxyMaps.read(paths, GeoPath.class);
            if (byBoat.containsKey(addressee.boat())) {
                return byBoat.get(addressee.boat());
            }
        }
        return new GeoPath(List.of());
    }

    /** Has a boat follow a path from where the mission is with it, and maybe stay there. */
    public static Move move(
            Activation activation, HandlerContext context, Addressee addressee, GeoPath path, boolean block) {
        String key = PathProgress.key(addressee.boat(), path);
        int visited = PathProgress.visited(
                context, activation.mission(), key, path.points().size());
        return move(activation, context, addressee, path, visited, block);
    }

    /** The same from the point on after the first so many, whatever the mission knows to be visited. */
    public static Move move(
            Activation activation,
            HandlerContext context,
            Addressee addressee,
            GeoPath path,
            int behind,
            boolean block) {
        String key = PathProgress.key(addressee.boat(), path);
        FollowPath command = new FollowPath(
                Move.commandId(activation, addressee),
                activation.mission(),
                activation.id(),
                path.points(),
                OptionalDouble.empty(),
                behind,
                activation.priority(),
                block && Move.mayBlock(activation, context));
        return new Move(addressee, command, Optional.of(new PathProgress.Along(key, 0)), Reply.WAY);
    }
}
