package org.sami.ui.map.base;

import java.util.ArrayList;
import java.util.List;
import org.sami.spn.value.GeoPoint;
import org.sami.ui.geo.Mercator;

/** The coordinates of one geometry as they are read, before its type is known: runs of positions, and which of them belong together. */
final class CoordinateRuns {
    /** A position of a MultiPolygon lies in so many lists. */
    static final int DEEPEST = 4;

    private static final int SAME = 4; // steps: a pixel of the finest scale

    private final Ints xs = new Ints();
    private final Ints ys = new Ints();
    private final Ints runEnds = new Ints();
    private final Ints groupEnds = new Ints(); // in runs
    private int depth;
    private int inRun; // positions of the run that is read
    private int runFrom;

    boolean isEmpty() {
        return xs.size() == 0;
    }

    /** How many points are kept. */
    int size() {
        return xs.size();
    }

    /** In how many lists positions lie. */
    int depth() {
        return depth;
    }

    void position(double lonDeg, double latDeg, int at) throws GeoJsonFault {
        if (depth != 0 && depth != at) {
            throw new GeoJsonFault("positions of one geometry lie equally deep in lists");
        }
        depth = at;
        int x = WorldInts.of(Mercator.x(lonDeg));
        int y = WorldInts.of(Mercator.y(latDeg));
        int last = xs.size() - 1;
        inRun++;
        if (inRun > 2 && Math.abs((long) x - xs.get(last)) < SAME && Math.abs((long) y - ys.get(last)) < SAME) {
            return; // nobody can tell it from the one before
        }
        xs.add(x);
        ys.add(y);
        if (at == 1) {
            endRun();
        }
    }

    /** A list at that depth ends. */
    void end(int at) throws GeoJsonFault {
        if (depth > 1 && at == depth - 1 && inRun > 0) {
            endRun();
        } else if (depth > 2 && at == depth - 2 && runEnds.size() > lastGroupEnd()) {
            groupEnds.add(runEnds.size());
        }
    }

    private void endRun() {
        runEnds.add(xs.size());
        runFrom = xs.size();
        inRun = 0;
    }

    private int lastGroupEnd() {
        return groupEnds.size() == 0 ? 0 : groupEnds.get(groupEnds.size() - 1);
    }

    /** Ends what is being read where it is. */
    void endHere() {
        if (inRun == 1) {
            inRun = 0; // a single point is no line
        } else if (xs.size() > runFrom) {
            endRun();
        }
    }

    /** The points, each for itself. */
    List<GeoPoint> points() {
        List<GeoPoint> points = new ArrayList<>();
        for (int i = 0; i < xs.size(); i++) {
            points.add(Mercator.point(WorldInts.unit(xs.get(i)), WorldInts.unit(ys.get(i))));
        }
        return points;
    }

    /** The runs as lines. */
    List<Run> lines() throws GeoJsonFault {
        List<Run> lines = new ArrayList<>();
        for (int i = 0; i < runEnds.size(); i++) {
            lines.add(line(i, false));
        }
        return lines;
    }

    /** The runs as rings, in groups. */
    List<List<Run>> polygons() throws GeoJsonFault {
        List<List<Run>> polygons = new ArrayList<>();
        int run = 0;
        for (int group = 0; group < groupEnds.size(); group++) {
            List<Run> rings = new ArrayList<>();
            while (run < groupEnds.get(group)) {
                rings.add(line(run++, true));
            }
            polygons.add(List.copyOf(rings));
        }
        return polygons;
    }

    private Run line(int run, boolean closed) throws GeoJsonFault {
        int from = run == 0 ? 0 : runEnds.get(run - 1);
        int to = runEnds.get(run);
        if (to - from < 2) {
            throw new GeoJsonFault("a line has two positions or more, and one has " + (to - from));
        }
        int[] x = xs.part(from, to);
        int[] y = ys.part(from, to);
        if (closed && (x[0] != x[x.length - 1] || y[0] != y[y.length - 1])) {
            x = java.util.Arrays.copyOf(x, x.length + 1);
            y = java.util.Arrays.copyOf(y, y.length + 1);
            x[x.length - 1] = x[0];
            y[y.length - 1] = y[0];
        }
        return new Run(x, y);
    }
}
