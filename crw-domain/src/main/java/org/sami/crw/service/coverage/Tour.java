package org.sami.crw.service.coverage;

import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.locationtech.jts.geom.Coordinate;

/**
 * One way through all cells of a sweep: always to the nearest corner of a cell that was not driven yet, from that corner of all at
 * which this gives the shortest ways between cells.
 */
final class Tour {
    /** With more cells than this only the corners of the first few are tried as a beginning: each try takes cells². */
    private static final int MOST_STARTS = 64;

    private record Visit(Cell cell, Cell.Entry entry) {
        Coordinate start() {
            return cell.start(entry);
        }

        Coordinate end() {
            return cell.end(entry);
        }
    }

    private final Travel travel;
    private final List<Coordinate> places = new ArrayList<>();

    private Tour(Travel travel) {
        this.travel = travel;
    }

    /** The places of the tour in order. Cells to which no way leads are left out. */
    static List<Coordinate> through(List<Cell> cells, Travel travel) {
        Tour tour = new Tour(travel);
        order(cells).forEach(tour::drive);
        return tour.places;
    }

    private static List<Visit> order(List<Cell> cells) {
        List<Visit> best = List.of();
        double bestM = Double.POSITIVE_INFINITY;
        int tried = 0;
        for (Visit first : visits(cells)) {
            if (tried++ < MOST_STARTS) {
                List<Visit> order = orderFrom(first, cells);
                double lengthM = betweenM(order);
                if (lengthM < bestM) {
                    best = order;
                    bestM = lengthM;
                }
            }
        }
        return best;
    }

    private static List<Visit> visits(Collection<Cell> cells) {
        List<Visit> visits = new ArrayList<>();
        cells.forEach(cell -> Cell.Entry.ALL.forEach(entry -> visits.add(new Visit(cell, entry))));
        return visits;
    }

    private static List<Visit> orderFrom(Visit first, List<Cell> cells) {
        List<Visit> order = new ArrayList<>(List.of(first));
        Set<Cell> left = new LinkedHashSet<>(cells);
        left.remove(first.cell());
        while (!left.isEmpty()) {
            Coordinate at = order.get(order.size() - 1).end();
            Visit nearest = first;
            double nearestM = Double.POSITIVE_INFINITY;
            for (Visit visit : visits(left)) {
                double distanceM = at.distance(visit.start());
                if (distanceM < nearestM) {
                    nearest = visit;
                    nearestM = distanceM;
                }
            }
            order.add(nearest);
            left.remove(nearest.cell());
        }
        return order;
    }

    private static double betweenM(List<Visit> order) {
        double lengthM = 0;
        for (int i = 1; i < order.size(); i++) {
            lengthM += order.get(i - 1).end().distance(order.get(i).start());
        }
        return lengthM;
    }

    private void drive(Visit visit) {
        for (Coordinate place : visit.cell().driven(visit.entry())) {
            if (places.isEmpty()) {
                places.add(place);
                continue;
            }
            Optional<List<Coordinate>> way = travel.between(places.get(places.size() - 1), place);
            way.ifPresent(found -> places.addAll(found.subList(1, found.size())));
        }
    }
}
