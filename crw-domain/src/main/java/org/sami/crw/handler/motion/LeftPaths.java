package org.sami.crw.handler.motion;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.sami.crw.proxy.BoatProxy;
import org.sami.crw.proxy.ProxyRegistry;
import org.sami.crw.proxy.command.BoatCommand;
import org.sami.crw.proxy.command.FollowPath;
import org.sami.spn.value.GeoPoint;

/**
 * What is left of the path that each boat drives, or was taken from it last: points that it has not visited. Not journalled: after a restart of the
 * base, what was taken from a boat before is not known. For the fleet's thread.
 */
public final class LeftPaths {
    private final ProxyRegistry boats;
    private final Map<String, List<GeoPoint>> taken = new HashMap<>();

    public LeftPaths(ProxyRegistry boats) {
        this.boats = boats;
    }

    /** A command was taken from a boat before its end. */
    void takenFrom(String boat, BoatCommand command, int visited) {
        if (command instanceof FollowPath path) {
            taken.put(
                    boat,
                    List.copyOf(path.startingAt(Math.max(path.startIndex(), visited))
                            .unvisitedPoints()));
        }
    }

    /** A boat came to the end of what it was sent to: nothing is left. */
    void finished(String boat) {
        taken.remove(boat);
    }

    /** The points that a boat has left; empty without any. */
    List<GeoPoint> of(String boat) {
        Optional<BoatProxy> proxy = boats.find(boat);
        Optional<BoatCommand> current = proxy.flatMap(one -> one.commands().current());
        if (current.orElse(null) instanceof FollowPath path) {
            int visited = proxy.get().commands().visitedCount(path.commandId()).orElse(0);
            return path.startingAt(Math.max(path.startIndex(), visited)).unvisitedPoints();
        }
        return taken.getOrDefault(boat, List.of());
    }
}
