package org.sami.crw.mavlink;

import java.util.Optional;
import org.sami.boat.link.Waypoint;
import org.sami.boat.server.vehicle.LocalFrame;
import org.sami.mavlink.vehicle.VehiclePosition;
import org.sami.mavlink.vehicle.VehicleSnapshot;

/** Whether a vehicle has come to the end of its list where its autopilot does not report that. For the gateway's thread. */
final class VehicleArrival {
    private static final double NEAR_M = 2.5; // of a place to which it went in GUIDED
    private static final double NEAR_AND_STILL_M = 3.5;
    private static final double STILL_MPS = 0.15;

    private final VehicleMotion motion;

    VehicleArrival(VehicleMotion motion) {
        this.motion = motion;
    }

    /** Whether a boat that was sent to a single place in GUIDED is there. */
    boolean isThere(DrivenList to) {
        Optional<VehiclePosition> at = motion.vehicle().position();
        if (!motion.isGuided() || to.isCompleted() || at.isEmpty()) {
            return false;
        }
        Waypoint last = to.waypoints().get(to.waypoints().size() - 1);
        double leftM = new LocalFrame(last.latDeg(), last.lonDeg())
                .distanceM(at.get().latDeg(), at.get().lonDeg());
        return leftM <= NEAR_M || (leftM <= NEAR_AND_STILL_M && at.get().speedMps() < STILL_MPS);
    }

    /** Whether a copter has landed at the end of its mission: it has turned its motors off, and nobody else has. */
    boolean hasLanded(DrivenList along) {
        VehicleSnapshot now = motion.vehicle();
        return along.lands()
                && !along.isCompleted()
                && along.isOnTheGround(along.next())
                && now.mode().equals(VehicleMotion.AUTO)
                && !now.armed()
                && motion.isOrdered();
    }
}
