package org.sami.crw.mavlink;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Iterator;
import java.util.List;
import java.util.OptionalInt;
import java.util.function.DoubleSupplier;
import java.util.stream.IntStream;
import org.sami.boat.link.Waypoint;
import org.sami.boat.server.vehicle.LocalFrame;
import org.sami.mavlink.vehicle.VehiclePosition;

/**
 * Where a vehicle has been since it last made progress along its list, by which a waypoint that it has only skipped is told from one whose report was lost: somebody else can set the
 * current item of its mission forward. For the gateway's thread.
 */
final class VehicleTrail {
    private static final double APART_M = 1; // of places that are kept
    private static final int MOST = 2_000; // of them: the last two kilometres
    private static final double SECOND_MS = 1_000;

    private final DoubleSupplier radiusM;
    private final Deque<Stay> stays = new ArrayDeque<>();

    /** It was about at a place until a time on its own clock, without a pause in its reports. */
    private record Stay(VehiclePosition at, long untilMs, long heardMs) {}

    /** A trail of a vehicle that counts a waypoint as reached within a radius, in metres. */
    VehicleTrail(DoubleSupplier radiusM) {
        this.radiusM = radiusM;
    }

    /** The vehicle has said where it is. */
    void add(VehiclePosition here) {
        if (!stays.isEmpty() && isSame(stays.getLast(), here)) {
            stays.addLast(new Stay(stays.removeLast().at(), here.bootMs(), here.heardMs()));
            return;
        }
        stays.addLast(new Stay(here, here.bootMs(), here.heardMs()));
        if (stays.size() > MOST) {
            stays.removeFirst();
        }
    }

    private static boolean isSame(Stay last, VehiclePosition here) {
        LocalFrame frame = new LocalFrame(last.at().latDeg(), last.at().lonDeg());
        return here.bootMs() - last.untilMs() <= SECOND_MS && frame.distanceM(here.latDeg(), here.lonDeg()) <= APART_M;
    }

    /** It has come to a waypoint: only the way from here on counts. */
    void restart() {
        while (stays.size() > 1) {
            stays.removeFirst();
        }
    }

    /** Whether it has said where it is after a time on the base's clock. */
    boolean isKnownAfter(long ms) {
        return !stays.isEmpty() && stays.getLast().heardMs() > ms;
    }

    /**
     * The first of some waypoints at which it cannot have been, by its number among them; empty where it can have been at all of them, also where it has not said since a
     * time where it is. While it did not report, it can have been wherever it could go meanwhile, by its own clock: a link delays reports, and a simulated vehicle may be faster
     * than the base's time.
     *
     * @param sinceMs when it said that it has passed them, on the base's clock
     */
    OptionalInt skipped(List<Waypoint> passed, long sinceMs) {
        return !isKnownAfter(sinceMs)
                ? OptionalInt.empty()
                : IntStream.range(0, passed.size())
                        .filter(number -> !canHaveBeenAt(passed.get(number)))
                        .findFirst();
    }

    private boolean canHaveBeenAt(Waypoint waypoint) {
        Iterator<Stay> all = stays.iterator();
        Stay from = all.next();
        while (all.hasNext()) {
            Stay to = all.next();
            if (isNear(waypoint, from, to.at())) {
                return true;
            }
            from = to;
        }
        return isNear(waypoint, from, from.at());
    }

    /** Whether it can have been at a waypoint on its way from one place to the next. */
    private boolean isNear(Waypoint waypoint, Stay from, VehiclePosition to) {
        double speedMps = Math.max(waypoint.speedMps(), Math.max(from.at().speedMps(), to.speedMps()));
        double meanwhileM = speedMps * Math.max(0, to.bootMs() - from.untilMs()) / SECOND_MS;
        return awayM(waypoint, from.at(), to) <= radiusM.getAsDouble() + MissionWatch.BESIDE_M + meanwhileM;
    }

    /** How far the straight way between two places is from a waypoint. */
    private static double awayM(Waypoint waypoint, VehiclePosition from, VehiclePosition to) {
        LocalFrame at = new LocalFrame(waypoint.latDeg(), waypoint.lonDeg());
        double eastM = at.eastM(from.latDeg(), from.lonDeg());
        double northM = at.northM(from.latDeg(), from.lonDeg());
        double wayEastM = at.eastM(to.latDeg(), to.lonDeg()) - eastM;
        double wayNorthM = at.northM(to.latDeg(), to.lonDeg()) - northM;
        double square = wayEastM * wayEastM + wayNorthM * wayNorthM;
        double nearest = square == 0 ? 0 : -(eastM * wayEastM + northM * wayNorthM) / square;
        double part = Math.max(0, Math.min(1, nearest));
        return Math.hypot(eastM + part * wayEastM, northM + part * wayNorthM);
    }
}
