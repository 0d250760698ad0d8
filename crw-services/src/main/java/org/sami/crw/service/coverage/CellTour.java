package org.sami.crw.service.coverage;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.locationtech.jts.geom.Coordinate;
import org.sami.crw.service.Interruption;

/**
 * A tour through all cells of a sweep: always to the nearest corner of a remaining cell, from the starting corner with the shortest ways between
 * cells.
 */
final class CellTour {
    /** With more cells than this only the corners of the first few are tried as a beginning: each try takes cells². */
    private static final int MOST_STARTS = 64;

    private static final int ENTRIES = Cell.Entry.ALL.size();

    private record Visit(Cell cell, Cell.Entry entry, Coordinate start, Coordinate end) {
        Visit(Cell cell, Cell.Entry entry) {
            this(cell, entry, cell.start(entry), cell.end(entry));
        }
    }

    private final LaneConnections travel;
    private final List<Coordinate> places = new ArrayList<>();

    private CellTour(LaneConnections travel) {
        this.travel = travel;
    }

    /** The places of the tour in order. Cells to which no way leads are left out. */
    static List<Coordinate> through(List<Cell> cells, LaneConnections travel) {
        CellTour tour = new CellTour(travel);
        order(cells).forEach(tour::drive);
        return tour.places;
    }

    private static List<Visit> order(List<Cell> cells) {
        Visit[] visits = cells.stream()
                .flatMap(cell -> Cell.Entry.ALL.stream().map(entry -> new Visit(cell, entry)))
                .toArray(Visit[]::new);
        int[] best = new int[0];
        double bestM = Double.POSITIVE_INFINITY;
        for (int first = 0; first < Math.min(MOST_STARTS, visits.length); first++) {
            int[] order = new int[cells.size()];
            double lengthM = orderFrom(first, visits, order);
            if (lengthM < bestM) {
                best = order;
                bestM = lengthM;
            }
        }
        return Arrays.stream(best).mapToObj(index -> visits[index]).toList();
    }

    /** Fills in the order from a first visit on; returns the length of the straight ways between. Four visits are one cell's. */
    private static double orderFrom(int first, Visit[] visits, int[] order) {
        boolean[] driven = new boolean[order.length];
        int at = first;
        double lengthM = 0;
        for (int i = 0; i < order.length; i++) {
            Interruption.check();
            order[i] = at;
            driven[at / ENTRIES] = true;
            int nearest = at;
            double nearestM = i + 1 < order.length ? Double.POSITIVE_INFINITY : 0;
            for (int next = 0; next < visits.length; next++) {
                if (!driven[next / ENTRIES]) {
                    double distanceM = visits[at].end().distance(visits[next].start());
                    if (distanceM < nearestM) {
                        nearest = next;
                        nearestM = distanceM;
                    }
                }
            }
            lengthM += nearestM;
            at = nearest;
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
