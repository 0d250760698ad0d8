package org.sami.crw.handler.motion;

import java.util.List;
import java.util.Optional;
import java.util.Set;

/** Moves of robots that are not commands yet, and that will be sent: services still compute them, or they wait for something. For the fleet's thread. */
public interface LaterMoves {
    /** The missions for which a robot has some. */
    Set<Long> missions(String robot);

    /** Those of these missions that the robot carries out already, although it has no command at this moment. */
    default Set<Long> begunMissions(String robot) {
        return Set.of();
    }

    /**
     * Takes back what a mission will have robots do; no robots named = all.
     *
     * @param why what the plan is told; empty where it asked for it itself, and nobody is told
     * @param motion takes back what will be sent through it
     */
    void withdraw(long mission, List<String> named, Optional<String> why, MotionCommands motion);
}
