package org.sami.crw.proxy.execution;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.sami.boat.link.MotionDefaults;
import org.sami.crw.service.LocalPlane;
import org.sami.crw.service.path.Detour;
import org.sami.crw.service.water.Water;
import org.sami.spn.value.GeoPoint;

/**
 * What a boat was driving along when its command was taken from it. Near no-go areas it slows down on that line before it turns to another: a boat that
 * turns at full speed leaves its line sideways by up to a boat's length and more, and would cut into the area that the line kept off.
 *
 * @param ahead the points that were still ahead of it, in driving order
 * @param speedMps the speed at which it drove
 * @param sinceMs when the command was taken from it
 */
record Underway(List<GeoPoint> ahead, double speedMps, long sinceMs) {
    /** A turn is mild if the boat drifts across its new line no faster than this, in m/s: boats take corners so. */
    private static final double TURN_DRIFT_MPS = 0.25;

    /** From so much farther than the boat needs to stop, in metres, an area is out of its reach. */
    private static final double ASIDE_M = 2;

    /** A boat drives on so long, in seconds, from its last report until it has its new path. */
    private static final double REACTION_S = 1.5;

    private static final double ROUNDING_M = 0.1;

    Underway {
        ahead = List.copyOf(ahead);
    }

    /** The distance in which the boat comes to rest, in metres. */
    private double stoppingM() {
        return speedMps * speedMps / (2 * MotionDefaults.BRAKING_MPS2);
    }

    /** Where a boat begins a new path: the place from which it is planned, and the points that it drives to before. */
    record Start(GeoPoint from, List<GeoPoint> before) {}

    /**
     * Where the boat begins its new path: a little ahead on its earlier line, as it drives on until it has the path; or, for more than a mild turn, where
     * it has slowed down on that line. At its position where it has room to turn, or has come to rest since.
     *
     * @param from where the boat is
     * @param to the first point of its new path
     */
    Start start(GeoPoint from, GeoPoint to, Water water, long nowMs) {
        boolean rests = nowMs - sinceMs > 1000 * speedMps / MotionDefaults.BRAKING_MPS2;
        double besideM = water.clearanceM(from);
        Start here = new Start(from, List.of());
        if (ahead.isEmpty() || rests || besideM <= 0 || besideM > speedMps * REACTION_S + stoppingM() + ASIDE_M) {
            return here;
        }
        double keptM = Math.min(besideM, water.error().steeringM()) - ROUNDING_M;
        return start(from, to, water, speedMps * REACTION_S, keptM)
                .or(() -> start(from, to, water, 0, keptM)) // a sharp corner is near: the boat is slow there
                .orElse(here);
    }

    private Optional<Start> start(GeoPoint from, GeoPoint to, Water water, double reactionM, double keptM) {
        LocalPlane plane = water.plane();
        List<GeoPoint> reaction = line(from, reactionM, 0, plane);
        GeoPoint begin = reactionM > 0 ? reaction.get(reaction.size() - 1) : from;
        GeoPoint next = line(from, reactionM + stoppingM(), reactionM, plane).get(0);
        GeoPoint first = Detour.between(begin, to, water).stream()
                .flatMap(List::stream)
                .findFirst()
                .orElse(to);
        double turnRad = courseRad(begin, first, plane) - courseRad(begin, next, plane);
        boolean isMild = Math.cos(turnRad) > 0 && speedMps * Math.abs(Math.sin(turnRad)) <= TURN_DRIFT_MPS;
        List<GeoPoint> before = isMild ? List.of() : line(from, reactionM + stoppingM(), reactionM, plane);
        List<GeoPoint> whole = new ArrayList<>(List.of(from));
        whole.addAll(isMild ? List.of(first) : before);
        return water.clearanceM(whole) >= keptM ? Optional.of(new Start(begin, before)) : Optional.empty();
    }

    /** The line ahead from one distance to another, in metres: the points between them, and its place at the farther one. */
    private List<GeoPoint> line(GeoPoint from, double toM, double fromM, LocalPlane plane) {
        List<GeoPoint> line = new ArrayList<>();
        double drivenM = 0;
        GeoPoint at = from;
        for (GeoPoint point : ahead) {
            double legM = plane.distanceM(at, point);
            if (drivenM + legM >= toM) {
                double part = (toM - drivenM) / legM;
                line.add(plane.point(
                        plane.x(at) + part * (plane.x(point) - plane.x(at)),
                        plane.y(at) + part * (plane.y(point) - plane.y(at))));
                return line;
            }
            drivenM += legM;
            at = point;
            if (drivenM > fromM) {
                line.add(point);
            }
        }
        return line.isEmpty() ? List.of(at) : line;
    }

    private static double courseRad(GeoPoint from, GeoPoint to, LocalPlane plane) {
        return Math.atan2(plane.x(to) - plane.x(from), plane.y(to) - plane.y(from));
    }
}
