package org.sami.crw.sim.run.record;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.TreeSet;
import org.sami.boat.server.vehicle.LocalFrame;
import org.sami.crw.report.DepthsPart.DepthCell;
import org.sami.crw.report.MapPoint;

/**
 * Squares of water with the depths that were measured in them. A square without a reading that lies between measured ones, no more than {@link #REACH} squares away
 * and on two sides, gets their mean, weighted by one over the fourth power of the distance. Others get none.
 */
final class DepthSquares {
    /** Side of a square, in metres. */
    static final double SIDE_M = 5;

    private static final int REACH = 3; // squares: lanes up to 20 m apart leave no gap
    private static final int MOST = 250_000;
    private static final double OPPOSITE =
            -0.85; // cosine of 148 degrees: less, and squares of one lane would count as on two sides of one beside it

    /** Of a square, counted from the area's centre. */
    private record Place(int north, int east) implements Comparable<Place> {
        @Override
        public int compareTo(Place other) {
            return north != other.north ? Integer.compare(north, other.north) : Integer.compare(east, other.east);
        }
    }

    private record Sum(double metres, int readings) {
        double meanM() {
            return metres / readings;
        }
    }

    private record Around(int byNorth, int byEast, double depthM) {
        double distance2() {
            return byNorth * byNorth + byEast * byEast;
        }

        double weight() {
            return 1 / (distance2() * distance2());
        }

        boolean isOpposite(Around other) {
            double dot = byNorth * other.byNorth + byEast * other.byEast;
            return dot <= OPPOSITE * Math.sqrt(distance2() * other.distance2());
        }
    }

    private final Map<Place, Sum> measured = new TreeMap<>();
    private long readings;

    /** Adds a reading at a place in metres; none in more squares than a report can hold. */
    void add(double eastM, double northM, double depthM) {
        Place at = new Place((int) Math.floor(northM / SIDE_M), (int) Math.floor(eastM / SIDE_M));
        if (measured.size() < MOST || measured.containsKey(at)) {
            measured.merge(
                    at,
                    new Sum(depthM, 1),
                    (before, now) -> new Sum(before.metres() + now.metres(), before.readings() + 1));
            readings++;
        }
    }

    /** How many readings were added. */
    long readings() {
        return readings;
    }

    /** All squares of which a depth is known, from the southwest on. */
    List<DepthCell> cells(LocalFrame plane) {
        TreeSet<Place> places = new TreeSet<>();
        for (Place at : measured.keySet()) {
            for (int north = -REACH; north <= REACH; north++) {
                for (int east = -REACH; east <= REACH; east++) {
                    places.add(new Place(at.north() + north, at.east() + east));
                }
            }
        }
        List<DepthCell> cells = new ArrayList<>();
        for (Place at : places) {
            Sum sum = measured.get(at);
            Optional<Double> depthM = sum == null ? between(at) : Optional.of(sum.meanM());
            depthM.ifPresent(
                    metres -> cells.add(new DepthCell(middle(at, plane), metres, sum == null ? 0 : sum.readings())));
        }
        return cells;
    }

    private Optional<Double> between(Place at) {
        List<Around> around = new ArrayList<>();
        for (int north = -REACH; north <= REACH; north++) {
            for (int east = -REACH; east <= REACH; east++) {
                Sum sum = measured.get(new Place(at.north() + north, at.east() + east));
                if (sum != null) {
                    around.add(new Around(north, east, sum.meanM()));
                }
            }
        }
        if (around.stream().noneMatch(one -> around.stream().anyMatch(one::isOpposite))) {
            return Optional.empty();
        }
        double weights = around.stream().mapToDouble(Around::weight).sum();
        return Optional.of(
                around.stream().mapToDouble(one -> one.weight() * one.depthM()).sum() / weights);
    }

    private static MapPoint middle(Place at, LocalFrame plane) {
        double eastM = (at.east() + 0.5) * SIDE_M;
        double northM = (at.north() + 0.5) * SIDE_M;
        return new MapPoint(plane.latDeg(eastM, northM), plane.lonDeg(eastM, northM), eastM, northM);
    }
}
