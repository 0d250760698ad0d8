package org.sami.crw.report;

import java.util.List;
import java.util.Optional;
import org.sami.boat.server.vehicle.PlaneMath;

/** Two boats' tracks, gone along at equal times; distances include the difference of their heights. While they are too far from one another to come near soon, time is leapt over. */
final class PairOfTracks {
    private static final double ROUNDING_M = 1e-6;

    private final Track one;
    private final Track other;

    /**
     * Where a boat was.
     *
     * @param fastestMPerMs the most that it covered between two points, in metres a millisecond
     */
    record Track(String boat, List<TrackPoint> points, double fastestMPerMs) {
        static Track of(BoatResult boat) {
            List<TrackPoint> points = boat.track();
            double fastest = 0;
            for (int i = 1; i < points.size(); i++) {
                TrackPoint from = points.get(i - 1);
                TrackPoint to = points.get(i);
                double metres = metres(to.eastM() - from.eastM(), to.northM() - from.northM(), to.altM() - from.altM());
                long millis = to.atMillis() - from.atMillis();
                if (metres > 0) {
                    fastest = millis > 0 ? Math.max(fastest, metres / millis) : Double.POSITIVE_INFINITY;
                }
            }
            return new Track(boat.id(), points, fastest);
        }
    }

    PairOfTracks(Track one, Track other) {
        this.one = one;
        this.other = other;
    }

    /**
     * Where they were nearest, from a time on, if that is nearer than what is known; else what is known. Nothing is nearer where they were never there
     * together after that time.
     */
    Optional<Approach> nearer(Optional<Approach> known, long fromMillis) {
        return nearerThan(known.map(Approach::distanceM).orElse(Double.MAX_VALUE), fromMillis)
                .or(() -> known);
    }

    /** Where they were nearest, from a time on, if that is nearer than so many metres. */
    Optional<Approach> nearerThan(double before, long fromMillis) {
        if (one.points.isEmpty() || other.points.isEmpty()) {
            return Optional.empty();
        }
        Way first = new Way(one.points);
        Way second = new Way(other.points);
        long at = Math.max(fromMillis, Math.max(first.begin(), second.begin()));
        long end = Math.min(first.end(), second.end());
        if (at > end) {
            return Optional.empty();
        }
        double least = before;
        double leastAt = at;
        double closingMPerMs = one.fastestMPerMs + other.fastestMPerMs;
        first.goTo(at);
        second.goTo(at);
        while (true) {
            long next = Math.min(end, Math.min(first.nextAfter(at), second.nextAfter(at)));
            double east = first.east(at) - second.east(at);
            double north = first.north(at) - second.north(at);
            double byEast = first.east(next) - second.east(next) - east;
            double byNorth = first.north(next) - second.north(next) - north;
            double up = first.up(at) - second.up(at);
            double byUp = first.up(next) - second.up(next) - up;
            double square = byEast * byEast + byNorth * byNorth + byUp * byUp;
            double along = east * byEast + north * byNorth + up * byUp;
            double part = square > 0 ? Math.min(1, Math.max(0, -along / square)) : 0;
            double distance = metres(east + part * byEast, north + part * byNorth, up + part * byUp);
            if (distance < least) {
                least = distance;
                leastAt = at + part * (next - at);
            }
            // at the end of the leg
            double farM = metres(east + byEast, north + byNorth, up + byUp) - least - ROUNDING_M;
            long soonest = farM > 0 ? next + (long) Math.min((double) (end - next), farM / closingMPerMs) : next;
            if (soonest >= end) {
                break;
            }
            first.goTo(soonest);
            second.goTo(soonest);
            at = Math.max(next, Math.max(first.legBegin(), second.legBegin()));
        }
        return least < before ? Optional.of(approach(Math.round(leastAt), least)) : Optional.empty();
    }

    /** How long they were nearer than so many metres, in milliseconds. */
    double millisNearer(double metres) {
        if (one.points.isEmpty() || other.points.isEmpty()) {
            return 0;
        }
        Way first = new Way(one.points);
        Way second = new Way(other.points);
        long end = Math.min(first.end(), second.end());
        long at = Math.max(first.begin(), second.begin());
        double millis = 0;
        while (at < end) {
            first.goTo(at);
            second.goTo(at);
            long next = Math.min(end, Math.min(first.nextAfter(at), second.nextAfter(at)));
            double east = first.east(at) - second.east(at);
            double north = first.north(at) - second.north(at);
            double byEast = first.east(next) - second.east(next) - east;
            double byNorth = first.north(next) - second.north(next) - north;
            double up = first.up(at) - second.up(at);
            double byUp = first.up(next) - second.up(next) - up;
            millis += partWithin(metres, new double[] {east, north, up}, new double[] {byEast, byNorth, byUp})
                    * (next - at);
            at = next;
        }
        return millis;
    }

    /** Which part of a straight way from a place lies nearer to the origin than so far: 0 to 1. */
    private static double partWithin(double metres, double[] apart, double[] by) {
        double square = product(by, by);
        double outside = product(apart, apart) - metres * metres;
        if (square == 0) {
            return outside < 0 ? 1 : 0;
        }
        double half = product(apart, by) / square;
        double root = half * half - outside / square;
        if (root <= 0) {
            return 0;
        }
        double from = Math.max(0, -half - Math.sqrt(root));
        double to = Math.min(1, -half + Math.sqrt(root));
        return Math.max(0, to - from);
    }

    private static double product(double[] one, double[] other) {
        return one[0] * other[0] + one[1] * other[1] + one[2] * other[2];
    }

    private static double metres(double east, double north, double up) {
        return up == 0 ? PlaneMath.length(east, north) : PlaneMath.length(PlaneMath.length(east, north), up);
    }

    private Approach approach(long atMillis, double distanceM) {
        TrackPoint a = new Way(one.points).at(atMillis);
        TrackPoint b = new Way(other.points).at(atMillis);
        double lonDeg = a.lonDeg() + Math.IEEEremainder(b.lonDeg() - a.lonDeg(), 360) / 2;
        return new Approach(
                one.boat,
                other.boat,
                atMillis,
                distanceM,
                new MapPoint(
                        (a.latDeg() + b.latDeg()) / 2,
                        Math.IEEEremainder(lonDeg, 360),
                        (a.eastM() + b.eastM()) / 2,
                        (a.northM() + b.northM()) / 2));
    }

    /** One track, gone along with rising times. */
    private static final class Way {
        private final List<TrackPoint> points;
        private int leg; // from this point to the next

        Way(List<TrackPoint> points) {
            this.points = points;
        }

        long begin() {
            return points.get(0).atMillis();
        }

        long end() {
            return points.get(points.size() - 1).atMillis();
        }

        long legBegin() {
            return from().atMillis();
        }

        /** Goes on to the leg in which a time lies; the later one of two. */
        void goTo(long atMillis) {
            int stride = 1;
            while (isBegun(leg + stride, atMillis)) {
                leg += stride;
                stride *= 2;
            }
            for (; stride > 0; stride /= 2) {
                if (isBegun(leg + stride, atMillis)) {
                    leg += stride;
                }
            }
        }

        private boolean isBegun(int other, long atMillis) {
            return other + 1 < points.size() && points.get(other).atMillis() <= atMillis;
        }

        long nextAfter(long atMillis) {
            for (int i = leg + 1; i < points.size(); i++) {
                if (points.get(i).atMillis() > atMillis) {
                    return points.get(i).atMillis();
                }
            }
            return Long.MAX_VALUE;
        }

        double east(long atMillis) {
            return between(atMillis, from().eastM(), to().eastM());
        }

        double north(long atMillis) {
            return between(atMillis, from().northM(), to().northM());
        }

        double up(long atMillis) {
            return between(atMillis, from().altM(), to().altM());
        }

        TrackPoint at(long atMillis) {
            goTo(atMillis);
            double lonTurnDeg = Math.IEEEremainder(to().lonDeg() - from().lonDeg(), 360);
            return new TrackPoint(
                    atMillis,
                    east(atMillis),
                    north(atMillis),
                    between(atMillis, from().latDeg(), to().latDeg()),
                    between(atMillis, from().lonDeg(), from().lonDeg() + lonTurnDeg),
                    from().speedMps(),
                    from().batteryPercent(),
                    up(atMillis));
        }

        private TrackPoint from() {
            return points.get(leg);
        }

        private TrackPoint to() {
            return points.get(Math.min(leg + 1, points.size() - 1));
        }

        private double between(long atMillis, double from, double to) {
            long span = to().atMillis() - from().atMillis();
            double part = span <= 0 ? 1 : (double) (atMillis - from().atMillis()) / span;
            return from + Math.min(1, Math.max(0, part)) * (to - from);
        }
    }
}
