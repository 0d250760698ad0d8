package org.sami.crw.proxy;

import java.util.ArrayList;
import java.util.Collection;
import java.util.Comparator;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.sami.boat.link.LinkDefaults;
import org.sami.boat.link.NearbyBoat;
import org.sami.boat.link.Traffic;
import org.sami.spn.value.GeoPoint;

/**
 * Sends each boat the boats near it, their motion, and the no-go edges to stay clear of while it gives way. A boat receives all boats within {@link
 * #NEAR_M} once a second, and at each check those within {@link #CLOSE_M} that have changed; it receives nothing while no boat is near or all lie
 * still. For the thread that drives the proxies.
 */
public final class TrafficRelay {
    /** Boats farther apart than this, in metres, need not know of each other: 13 s at cruise speed, head on. */
    static final double NEAR_M = 40;

    /** Boats closer than this, in metres, receive every change of each other. */
    static final double CLOSE_M = 20;

    /** Age in ms beyond which a report is no longer passed on: the time after which a link counts as lost. */
    static final long MAX_AGE_MS = LinkDefaults.LINK_LOST_AFTER_MS;

    private static final long CHECK_MS = 200;
    private static final long PERIOD_MS = 1000;
    private static final int CHECKS = (int) (PERIOD_MS / CHECK_MS); // in a period
    private static final double METRES_PER_DEGREE = 111_320; // of latitude; a rough value is enough to find near boats
    private static final Comparator<Seen> FROM_WEST = Comparator.comparingDouble(seen -> seen.eastM);

    private final List<Seen> inOrder = new ArrayList<>(); // as the boats are given
    private final List<Seen> fromWest = new ArrayList<>(); // the same; nearly sorted from check to check
    private long checkedMs = Long.MIN_VALUE / 2;
    private int boatsSeen; // ever

    /** Metres east and north of one of the boats. */
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

    /** A boat with its position at the last check. */
    private static final class Seen {
        private final BoatProxy boat;
        // the check of a period at which it receives all boats: spreads the load over the period
        private final int turn;
        private final List<Seen> near = new ArrayList<>();
        private @Nullable Sighting sighting; // none before the first look
        private boolean isNews; // it has changed since the check before
        private long atMs;
        private double eastM;
        private double northM;
        private boolean isAtRest;
        private Optional<NearbyBoat> row = Optional.empty(); // made when first needed
        private boolean isConcerned; // this boat or one near it is under way
        private boolean isClose; // the same within CLOSE_M
        private long allSentMs = Long.MIN_VALUE / 2;

        Seen(BoatProxy boat, int turn) {
            this.boat = boat;
            this.turn = turn;
        }

        void look(Sighting newest, Plane plane, long nowMs) {
            isNews = !newest.equals(sighting);
            sighting = newest;
            atMs = nowMs;
            eastM = plane.eastM(newest);
            northM = plane.northM(newest);
            isAtRest = newest.isAtRest();
            near.clear();
            row = Optional.empty();
            isConcerned = false;
            isClose = false;
        }

        boolean isDueToAll(long nowMs) {
            return nowMs - allSentMs >= PERIOD_MS || nowMs / CHECK_MS % CHECKS == turn;
        }

        boolean isNewsTo(Seen other) {
            return isNews && squareTo(other) <= CLOSE_M * CLOSE_M;
        }

        double squareTo(Seen other) {
            double byEastM = other.eastM - eastM;
            double byNorthM = other.northM - northM;
            return byEastM * byEastM + byNorthM * byNorthM;
        }
    }

    /** Sends to the boats that are due. To be called ten times a second; it checks the boats five times a second. */
    public void tick(Collection<BoatProxy> boats, long nowMs) {
        boats.forEach(boat -> tellEdges(boat, nowMs));
        if (boats.size() < 2 || nowMs - checkedMs < CHECK_MS) {
            return;
        }
        checkedMs = nowMs;
        look(
                boats.stream().filter(boat -> !boat.isFlying()).toList(),
                nowMs); // aircraft are kept apart by their altitudes
        pairUp();
        for (Seen seen : fromWest) {
            if (seen.isConcerned && seen.boat.traffic().takesTraffic()) {
                tell(seen, nowMs);
            }
        }
    }

    /** A boat that sees a vessel of nobody's gives way to it outside no-go areas, also where no boat of the base is near. */
    private static void tellEdges(BoatProxy boat, long nowMs) {
        if (boat.traffic().isDueToEdges(nowMs)
                && boat.traffic().takesTraffic()
                && boat.traffic().noGoEdges().isPresent()) {
            boat.traffic().tell(new Traffic(List.of(), boat.traffic().noGoEdges()));
        }
    }

    private static void tell(Seen seen, long nowMs) {
        if (seen.isDueToAll(nowMs)) {
            seen.allSentMs = nowMs;
        } else if (seen.isClose) {
            seen.near.removeIf(other -> !other.isNewsTo(seen));
        } else {
            return;
        }
        if (!seen.near.isEmpty()) {
            seen.boat
                    .traffic()
                    .tell(new Traffic(rows(seen, nowMs), seen.boat.traffic().noGoEdges()));
        }
    }

    /** Updates the positions of the boats that have a recent one; forgets the others. */
    private void look(Collection<BoatProxy> boats, long nowMs) {
        Plane plane = null; // of the first one
        int count = 0;
        for (BoatProxy boat : boats) {
            Optional<Sighting> sighting = boat.traffic().sighting();
            if (sighting.isPresent() && nowMs - sighting.get().atMs() <= MAX_AGE_MS) {
                plane = plane == null ? Plane.at(sighting.get()) : plane;
                seen(boat, count).look(sighting.get(), plane, nowMs);
                count++;
            }
        }
        inOrder.subList(count, inOrder.size()).clear();
        fromWest.removeIf(seen -> seen.atMs != nowMs);
    }

    /** The entry of a boat that comes after {@code before} others; it usually has the same index as at the last check. */
    private Seen seen(BoatProxy boat, int before) {
        for (int i = before; i < inOrder.size(); i++) {
            if (inOrder.get(i).boat == boat) {
                inOrder.subList(before, i).clear(); // they are gone
                return inOrder.get(before);
            }
        }
        Seen seen = new Seen(boat, boatsSeen++ % CHECKS);
        inOrder.add(before, seen);
        fromWest.add(seen);
        return seen;
    }

    /** Finds the pairs of near boats. The boats are sorted from west to east, so that not all pairs have to be compared. */
    private void pairUp() {
        fromWest.sort(FROM_WEST);
        for (int i = 0; i < fromWest.size(); i++) {
            Seen one = fromWest.get(i);
            for (int j = i + 1; j < fromWest.size() && fromWest.get(j).eastM - one.eastM <= NEAR_M; j++) {
                pairUp(one, fromWest.get(j));
            }
        }
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
            boolean underWay = !one.isAtRest || !other.isAtRest;
            boolean close = underWay && square <= CLOSE_M * CLOSE_M;
            one.isConcerned |= underWay;
            other.isConcerned |= underWay;
            one.isClose |= close;
            other.isClose |= close;
        }
    }

    /** The rows of the nearest boats, as many as a message takes. */
    private static List<NearbyBoat> rows(Seen seen, long nowMs) {
        List<Seen> near = seen.near;
        if (near.size() > Traffic.MOST_BOATS) {
            near.sort(Comparator.comparingDouble(seen::squareTo));
            near = near.subList(0, Traffic.MOST_BOATS);
        }
        List<NearbyBoat> rows = new ArrayList<>(near.size());
        for (Seen other : near) {
            if (other.row.isEmpty()) {
                other.row = Optional.of(row(other, nowMs));
            }
            rows.add(other.row.get());
        }
        return rows;
    }

    private static NearbyBoat row(Seen other, long nowMs) {
        Sighting at = Objects.requireNonNull(other.sighting, "a boat is near once it was looked at");
        Optional<GeoPoint> to = other.boat.traffic().target();
        boolean isGoing = to.isPresent();
        return new NearbyBoat(
                other.boat.boatId(),
                at.latDeg(),
                at.lonDeg(),
                at.headingRad(),
                at.speedMps(),
                at.mode(),
                Math.max(0, nowMs - at.atMs()),
                isGoing ? to.get().latDeg() : Double.NaN,
                isGoing ? to.get().lonDeg() : Double.NaN);
    }
}
