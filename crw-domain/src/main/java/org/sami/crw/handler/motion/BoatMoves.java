package org.sami.crw.handler.motion;

import java.util.Optional;
import java.util.Set;
import org.sami.crw.proxy.BoatProxy;

/** The output events that send boats over the water. A robot that flies gets none of their commands; it has events of its own. */
public final class BoatMoves {
    /** By name. */
    public static final Set<String> TYPES = Set.of(
            ExecutePathHandler.TYPE,
            ExecutePathHandler.BLOCKING_TYPE,
            GotoPointHandler.TYPE,
            GotoPointHandler.BLOCKING_TYPE,
            GotoLatLonHandler.TYPE,
            GotoLocationListHandler.TYPE,
            StationKeepHandler.TYPE,
            "ProxyExploreArea"); // its handler plans as well, and is not of this package

    private BoatMoves() {}

    /** Why a robot cannot do what an event asks, as far as its kind goes; empty where it can. */
    static Optional<String> refusal(String event, BoatProxy robot) {
        return robot.isFlying() && TYPES.contains(event)
                ? Optional.of("it flies, and this is for boats")
                : Optional.empty();
    }
}
