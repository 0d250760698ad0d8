package org.sami.crw.sim.report;

import java.util.List;
import java.util.Optional;

/** Two boats' tracks, gone along at equal times. */
final class PairOfTracks {
    private final BoatResult one;
    private final BoatResult other;

    PairOfTracks(BoatResult one, BoatResult other) {
        this.one = one;
        this.other = other;
    }

    /**
     * Where they were nearest, from a time on.
     *
     * @return empty where they were never there together after it
     */
    Optional<Approach> nearest(long fromMillis) {
        if (one.track().isEmpty() || other.track().isEmpty()) {
            return Optional.empty();
        }
        Way first = new Way(one.track());
        Way second = new Way(other.track());
        long at = Math.max(fromMillis, Math.max(first.begin(), second.begin()));
        long end = Math.min(first.end(), second.end());
        if (at > end) {
            return Optional.empty();
        }
        double least = Double.MAX_VALUE;
        double leastAt = at;
        first.goTo(at);
        second.goTo(at);
        while (true) {
            long next = Math.min(end, Math.min(first.nextAfter(at), second.nextAfter(at)));
            double east = first.east(at) - second.east(at);
            double north = first.north(at) - second.north(at);
            double byEast = first.east(next) - second.east(next) - east;
            double byNorth = first.north(next) - second.north(next) - north;
            double square = byEast * byEast + byNorth * byNorth;
            double part = square > 0 ? Math.min(1, Math.max(0, -(east * byEast + north * byNorth) / square)) : 0;
            double distance = Math.hypot(east + part * byEast, north + part * byNorth);
            if (distance < least) {
                least = distance;
                leastAt = at + part * (next - at);
            }
            if (next >= end) {
                break;
            }
            at = next;
            first.goTo(at);
            second.goTo(at);
        }
        return Optional.of(approach(Math.round(leastAt), least));
    }

    private Approach approach(long atMillis, double distanceM) {
        TrackPoint a = new Way(one.track()).at(atMillis);
        TrackPoint b = new Way(other.track()).at(atMillis);
        double lonDeg = a.lonDeg() + Math.IEEEremainder(b.lonDeg() - a.lonDeg(), 360) / 2;
        return new Approach(
                one.id(),
                other.id(),
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

        /** Goes on to the leg in which a time lies; the later one of two. */
        void goTo(long atMillis) {
            while (leg + 2 < points.size() && points.get(leg + 1).atMillis() <= atMillis) {
                leg++;
            }
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
                    from().batteryPercent());
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
