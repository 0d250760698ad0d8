package org.sami.crw.proxy;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collection;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.sami.boat.link.NearbyBoat;
import org.sami.boat.link.Traffic;
import org.sami.spn.value.GeoPoint;

/**
 * Tells each boat which others are near it and how they move, so that boats give way to one another. Once a second where others are within
 * {@link #NEAR_M}, as often as they tell where they are where some are within {@link #CLOSE_M}, and nothing where nobody is or all lie still.
 * For the thread that drives the proxies.
 */
public final class TrafficRelay {
    /** Two boats that are farther from one another, in metres, need not know of each other: 13 s at cruise speed, head on. */
    static final double NEAR_M = 40;

    /** Two boats that are nearer, in metres, are told of each other as often as anything new is known. */
    static final double CLOSE_M = 20;

    /** What is older, in ms, is passed on no more: the time after which a link counts as lost. */
    static final long OLDEST_MS = 3500;

    private static final long LOOK_MS = 200;
    private static final long PERIOD_MS = 1000;
    private static final double METRES_PER_DEGREE = 111_320; // of latitude; coarse is enough to see who is near

    private final Map<String, Long> toldMs = new HashMap<>();
    private long lookedMs = Long.MIN_VALUE / 2;

    /** Metres east and north of where one of the boats is. */
    private record Plane(Sighting origin, double metresPerDegreeEast) {
        static Plane at(Sighting origin) {
            return new Plane(origin, METRES_PER_DEGREE * StrictMath.cos(Math.toRadians(origin.latDeg())));
        }

        double eastM(Sighting sighting) {
            double turnDeg = sighting.lonDeg() - origin.lonDeg();
            return (Math.abs(turnDeg) <= 180 ? turnDeg : Math.IEEEremainder(turnDeg, 360)) * metresPerDegreeEast;
        }

        double northM(Sighting sighting) {
            return (sighting.latDeg() - origin.latDeg()) * METRES_PER_DEGREE;
        }
    }

    /** A boat that was seen lately, on a plane. */
    private static final class Seen {
        private final BoatProxy boat;
        private final Sighting sighting;
        private final double eastM;
        private final double northM;
        private final List<Seen> near = new ArrayList<>(0); // most are far from all others
        private NearbyBoat row; // once somebody is to be told of it
        private boolean isConcerned; // somebody is under way, this boat or one near it
        private boolean isClose; // likewise, and so near that it is told often

        Seen(BoatProxy boat, Sighting sighting, Plane plane) {
            this.boat = boat;
            this.sighting = sighting;
            eastM = plane.eastM(sighting);
            northM = plane.northM(sighting);
        }

        double squareTo(Seen other) {
            double byEastM = other.eastM - eastM;
            double byNorthM = other.northM - northM;
            return byEastM * byEastM + byNorthM * byNorthM;
        }
    }

    /** Lets time pass, and tells who is to be told. To be called ten times a second; it looks five times. */
    public void tick(Collection<BoatProxy> boats, long nowMs) {
        if (boats.size() < 2 || nowMs - lookedMs < LOOK_MS) {
            return;
        }
        lookedMs = nowMs;
        for (Seen seen : pairUp(seenOf(boats, nowMs))) {
            if (seen.isConcerned && seen.boat.takesTraffic() && isDue(seen, nowMs)) {
                toldMs.put(seen.boat.boatId(), nowMs);
                seen.boat.tellTraffic(new Traffic(rows(seen, nowMs)));
            }
        }
    }

    private boolean isDue(Seen seen, long nowMs) {
        return seen.isClose || nowMs - toldMs.getOrDefault(seen.boat.boatId(), Long.MIN_VALUE / 2) >= PERIOD_MS;
    }

    private static Seen[] seenOf(Collection<BoatProxy> boats, long nowMs) {
        List<Seen> seen = new ArrayList<>(boats.size());
        Plane plane = null; // of the first one
        for (BoatProxy boat : boats) {
            Optional<Sighting> sighting = boat.sighting();
            if (sighting.isPresent() && nowMs - sighting.get().atMs() <= OLDEST_MS) {
                plane = plane == null ? Plane.at(sighting.get()) : plane;
                seen.add(new Seen(boat, sighting.get(), plane));
            }
        }
        return seen.toArray(Seen[]::new);
    }

    /** Who is near whom: gone through from west to east, so that not all pairs are looked at. */
    private static Seen[] pairUp(Seen[] seen) {
        Arrays.sort(seen, Comparator.comparingDouble((Seen one) -> one.eastM));
        for (int i = 0; i < seen.length; i++) {
            for (int j = i + 1; j < seen.length && seen[j].eastM - seen[i].eastM <= NEAR_M; j++) {
                pairUp(seen[i], seen[j]);
            }
        }
        return seen;
    }

    private static void pairUp(Seen one, Seen other) {
        double northM = other.northM - one.northM;
        if (Math.abs(northM) > NEAR_M) {
            return;
        }
        double square = one.squareTo(other);
        if (square <= NEAR_M * NEAR_M) {
            one.near.add(other);
            other.near.add(one);
            boolean underWay = !one.sighting.isAtRest() || !other.sighting.isAtRest();
            boolean close = underWay && square <= CLOSE_M * CLOSE_M;
            one.isConcerned |= underWay;
            other.isConcerned |= underWay;
            one.isClose |= close;
            other.isClose |= close;
        }
    }

    /** The nearest ones, as many as a message takes. */
    private static List<NearbyBoat> rows(Seen seen, long nowMs) {
        List<Seen> near = seen.near;
        if (near.size() > Traffic.MOST_BOATS) {
            near.sort(Comparator.comparingDouble(seen::squareTo));
            near = near.subList(0, Traffic.MOST_BOATS);
        }
        List<NearbyBoat> rows = new ArrayList<>(near.size());
        for (Seen other : near) {
            if (other.row == null) {
                other.row = row(other, nowMs);
            }
            rows.add(other.row);
        }
        return rows;
    }

    private static NearbyBoat row(Seen other, long nowMs) {
        Sighting at = other.sighting;
        Optional<GeoPoint> to = other.boat.target();
        return new NearbyBoat(
                other.boat.boatId(),
                at.latDeg(),
                at.lonDeg(),
                at.headingRad(),
                at.speedMps(),
                at.mode(),
                Math.max(0, nowMs - at.atMs()),
                to.map(GeoPoint::latDeg).orElse(Double.NaN),
                to.map(GeoPoint::lonDeg).orElse(Double.NaN));
    }
}
