package org.sami.crw.service.coverage;

import java.util.ArrayList;
import java.util.List;
import org.locationtech.jts.geom.Coordinate;
import org.locationtech.jts.geom.Geometry;

/**
 * Lanes of successive lines, one a line, each next to the following one and no other: a boat drives them one after the other, to and fro (H.
 * Choset, P. Pignon, Coverage path planning: the boustrophedon cellular decomposition, 1997; here by lanes).
 */
final class Cell {
    /** From which of its four corners a cell is driven. */
    record Entry(boolean fromLastRow, boolean fromEnd) {
        static final List<Entry> ALL =
                List.of(new Entry(false, false), new Entry(false, true), new Entry(true, false), new Entry(true, true));
    }

    private final List<Lane> lanes = new ArrayList<>();

    private Cell(Lane first) {
        lanes.add(first);
    }

    /** The cells of a sweep, by the polygons in which they lie, then in the order of their first lanes. */
    static List<Cell> of(SweepLanes sweep, Geometry drivable) {
        List<Cell> cells = new ArrayList<>();
        for (int i = 0; i < drivable.getNumGeometries(); i++) {
            Geometry polygon = drivable.getGeometryN(i);
            cells.addAll(of(sweep.rows().stream()
                    .map(row -> row.stream()
                            .filter(lane -> lane.isIn(polygon, drivable))
                            .toList())
                    .toList()));
        }
        return cells;
    }

    private static List<Cell> of(List<List<Lane>> rows) {
        List<Cell> cells = new ArrayList<>();
        List<Cell> open = List.of();
        List<Lane> before = List.of();
        for (List<Lane> row : rows) {
            List<Cell> next = new ArrayList<>();
            for (Lane lane : row) {
                List<Cell> beside =
                        open.stream().filter(cell -> cell.last().isNextTo(lane)).toList();
                if (beside.size() == 1
                        && row.stream().filter(beside.get(0).last()::isNextTo).count() == 1) {
                    next.add(beside.get(0));
                } else {
                    Cell cell = new Cell(lane);
                    cells.add(cell);
                    next.add(cell);
                }
            }
            for (int i = 0; i < row.size(); i++) {
                if (before.contains(next.get(i).last())) {
                    next.get(i).lanes.add(row.get(i));
                }
            }
            open = next;
            before = row;
        }
        return cells;
    }

    private Lane last() {
        return lanes.get(lanes.size() - 1);
    }

    /** Whether it lies in a polygon, one of several in one of which it does. */
    boolean isIn(Geometry polygon, Geometry all) {
        return lanes.get(0).isIn(polygon, all);
    }

    /** The two ends of each lane. */
    List<List<Coordinate>> lanes() {
        return lanes.stream().map(lane -> List.of(lane.start(), lane.end())).toList();
    }

    /** Where a boat that enters so begins. */
    Coordinate start(Entry entry) {
        Lane lane = entry.fromLastRow() ? last() : lanes.get(0);
        return entry.fromEnd() ? lane.end() : lane.start();
    }

    /** Where it then ends. */
    Coordinate end(Entry entry) {
        Lane lane = entry.fromLastRow() ? lanes.get(0) : last();
        boolean atEnd = entry.fromEnd() == (lanes.size() % 2 == 0);
        return atEnd ? lane.end() : lane.start();
    }

    /** The ends of all lanes in the order in which a boat that enters so passes them. */
    List<Coordinate> driven(Entry entry) {
        List<Coordinate> places = new ArrayList<>();
        boolean fromEnd = entry.fromEnd();
        for (int i = 0; i < lanes.size(); i++) {
            Lane lane = lanes.get(entry.fromLastRow() ? lanes.size() - 1 - i : i);
            places.add(fromEnd ? lane.end() : lane.start());
            places.add(fromEnd ? lane.start() : lane.end());
            fromEnd = !fromEnd;
        }
        return places;
    }
}
