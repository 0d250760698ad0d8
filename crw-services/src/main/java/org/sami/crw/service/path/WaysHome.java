package org.sami.crw.service.path;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.sami.crw.service.Geodesy;
import org.sami.crw.service.water.Water;
import org.sami.spn.value.GeoPoint;

/**
 * Finds the ways home from a path, clear of what is forbidden: for each leg those that a boat can take from anywhere on the leg. A way is a list of
 * the points at which it turns before home.
 */
public final class WaysHome {
    /** A known way that is longer than the straight one by this factor is compared with a new search. */
    private static final double WORTH_A_SEARCH = 1.25;

    private final GeoPoint home;
    private final Water water;

    private WaysHome(GeoPoint home, Water water) {
        this.home = home;
        this.water = water.leaving(home);
    }

    /**
     * The ways home from each leg of a path, by the index of the point to which the leg leads. A leg has one way if all of it sees the way's first
     * turn; else one from each of its ends; none if it is not driven any more, or if there is no way. Empty if every leg has the straight way
     * home.
     *
     * @param from where the boat begins
     * @param first index of the point to which it drives first
     */
    public static List<List<List<GeoPoint>>> of(
            GeoPoint from, List<GeoPoint> path, int first, GeoPoint home, Water water) {
        return new WaysHome(home, water).ofLegs(from, path, first);
    }

    private List<List<List<GeoPoint>>> ofLegs(GeoPoint from, List<GeoPoint> path, int first) {
        List<List<List<GeoPoint>>> ofLegs = new ArrayList<>();
        boolean isStraight = true;
        GeoPoint start = from;
        Optional<List<GeoPoint>> atStart = ofPoint(start, Optional.empty());
        for (int i = 0; i < path.size(); i++) {
            List<List<GeoPoint>> ofLeg = List.of();
            if (i >= first) {
                GeoPoint end = path.get(i);
                Optional<List<GeoPoint>> atEnd = ofPoint(end, atStart);
                ofLeg = ofLeg(start, atStart, end, atEnd);
                isStraight &= ofLeg.equals(List.of(List.of()));
                start = end;
                atStart = atEnd;
            }
            ofLegs.add(ofLeg);
        }
        return isStraight ? List.of() : ofLegs;
    }

    /**
     * The way home from a point: the way from the point before, from the last of its turns that is seen from here, unless that is far about; else a
     * new one. Empty if there is none.
     */
    private Optional<List<GeoPoint>> ofPoint(GeoPoint point, Optional<List<GeoPoint>> before) {
        if (Detour.isClear(point, home, water)) {
            return Optional.of(List.of());
        }
        Optional<List<GeoPoint>> known = Optional.empty();
        List<GeoPoint> turns = before.orElse(List.of());
        for (int i = turns.size() - 1; i >= 0 && known.isEmpty(); i--) {
            if (Detour.isClear(point, turns.get(i), water)) {
                known = Optional.of(turns.subList(i, turns.size()));
            }
        }
        double worthM = WORTH_A_SEARCH * Geodesy.distanceM(point, home);
        if (known.isPresent() && lengthM(point, known.get()) <= worthM) {
            return known;
        }
        return shorter(point, known, Detour.between(point, home, water));
    }

    private Optional<List<GeoPoint>> shorter(
            GeoPoint from, Optional<List<GeoPoint>> one, Optional<List<GeoPoint>> other) {
        if (one.isEmpty() || other.isEmpty()) {
            return one.or(() -> other);
        }
        return lengthM(from, one.get()) <= lengthM(from, other.get()) ? one : other;
    }

    private List<List<GeoPoint>> ofLeg(
            GeoPoint start, Optional<List<GeoPoint>> atStart, GeoPoint end, Optional<List<GeoPoint>> atEnd) {
        Optional<List<GeoPoint>> seen = shorter(
                end, atStart.flatMap(way -> seen(start, end, way)), atEnd.flatMap(way -> seen(start, end, way)));
        if (seen.isPresent()) {
            return List.of(seen.get());
        }
        List<List<GeoPoint>> ofEnds = new ArrayList<>();
        atStart.ifPresent(way -> ofEnds.add(joined(start, way)));
        atEnd.ifPresent(way -> ofEnds.add(joined(end, way)));
        return ofEnds;
    }

    /** The rest of a way from the last of its turns that is seen from everywhere on a leg; empty if none is. */
    private Optional<List<GeoPoint>> seen(GeoPoint start, GeoPoint end, List<GeoPoint> way) {
        double legM = water.clearanceM(List.of(start, end));
        for (int i = way.size(); i >= 0; i--) {
            GeoPoint place = i < way.size() ? way.get(i) : home;
            double plannedM = Math.min(Math.min(legM, water.margin().pathM()), water.clearanceM(place));
            if (water.clearanceBetweenM(List.of(start, end, place)) >= Detour.leastM(plannedM)) {
                return Optional.of(way.subList(i, way.size()));
            }
        }
        return Optional.empty();
    }

    private static List<GeoPoint> joined(GeoPoint first, List<GeoPoint> way) {
        List<GeoPoint> all = new ArrayList<>(List.of(first));
        all.addAll(way);
        return all;
    }

    private double lengthM(GeoPoint from, List<GeoPoint> turns) {
        return Geodesy.lengthM(from, turns)
                + Geodesy.distanceM(turns.isEmpty() ? from : turns.get(turns.size() - 1), home);
    }
}
