package org.sami.crw.service.reach;

import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.stream.Stream;
import org.sami.crw.service.Geodesy;
import org.sami.crw.service.path.Detour;
import org.sami.crw.service.water.Water;
import org.sami.spn.value.GeoPoint;

/**
 * The flight that an aircraft is to make. Altitudes are metres above the place of the take-off.
 *
 * @param from where the aircraft is
 * @param points along which it flies, in order; none for one that stays where it is
 * @param speedMps over ground, more than 0
 * @param staysS how long it stays at the end, in seconds
 * @param home where it lands; empty where that is not known
 * @param water areas that it flies around; empty = none
 */
public record Flight(
        String aircraft,
        GeoPoint from,
        List<GeoPoint> points,
        double speedMps,
        double staysS,
        Optional<GeoPoint> home,
        Optional<Water> water) {
    private static final double CLIMB_MPS =
            2.5; // this and the next are ArduPilot's for missions, unless it is told others
    private static final double DESCENT_MPS = 1.5;

    /** How fast copters return home, in m/s. */
    public static final double HOME_MPS = 8;

    private static final double HOME_ALT_M = 15; // copters return home at it at least
    private static final double GROUND_M = 0.5;

    public Flight {
        Objects.requireNonNull(aircraft, "aircraft");
        Objects.requireNonNull(from, "from");
        points = List.copyOf(points);
        Objects.requireNonNull(home, "home");
        Objects.requireNonNull(water, "water");
        if (!(speedMps > 0)) {
            throw new IllegalArgumentException("an aircraft flies faster than 0 m/s, not " + speedMps);
        }
    }

    /** Whether it ends on the ground, as a return home does. */
    public boolean lands() {
        return end().altM() < GROUND_M;
    }

    /** Where it is at its end, before it comes home. */
    public GeoPoint end() {
        return points.isEmpty() ? from : points.get(points.size() - 1);
    }

    /** How long it takes to the end of its points, and to stay there, in seconds. One on the ground climbs on the spot before it goes anywhere. */
    public double outS() {
        double alongS = Geodesy.lengthM(from, Detour.along(from, points, water)) / speedMps;
        double seconds = staysS;
        GeoPoint at = from;
        for (GeoPoint point : points) {
            double verticalS = verticalS(at.altM(), point.altM());
            boolean climbsFirst = at.altM() < GROUND_M;
            double levelS = Geodesy.distanceM(at, point) / speedMps;
            seconds += climbsFirst ? verticalS : Math.max(0, verticalS - levelS); // else it climbs on its way
            at = point;
        }
        return seconds + alongS;
    }

    /** How long its way home takes from there, and to land, in seconds; only to land where its home is not known. */
    public double homeS() {
        GeoPoint end = end();
        if (home.isEmpty()) {
            return verticalS(end.altM(), 0);
        }
        double altM = Math.max(end.altM(), HOME_ALT_M);
        Optional<Water> around = water.map(one -> one.leaving(home.get()));
        return verticalS(end.altM(), altM)
                + Geodesy.lengthM(end, Detour.along(end, List.of(home.get()), around)) / HOME_MPS
                + verticalS(altM, 0);
    }

    /** The points of a way home: up to an altitude above trees and masts, to above the home, and down. */
    public static List<GeoPoint> wayHome(GeoPoint from, GeoPoint home) {
        double altM = Math.max(from.altM(), HOME_ALT_M);
        Stream<GeoPoint> up = from.altM() < altM ? Stream.of(at(from, altM)) : Stream.empty();
        return Stream.concat(up, Stream.of(at(home, altM), at(home, 0))).toList();
    }

    private static GeoPoint at(GeoPoint place, double altM) {
        return new GeoPoint(place.latDeg(), place.lonDeg(), altM);
    }

    private static double verticalS(double fromM, double toM) {
        return toM > fromM ? (toM - fromM) / CLIMB_MPS : (fromM - toM) / DESCENT_MPS;
    }
}
