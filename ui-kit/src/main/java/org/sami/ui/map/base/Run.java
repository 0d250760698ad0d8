package org.sami.ui.map.base;

import org.locationtech.jts.geom.Coordinate;
import org.locationtech.jts.geom.Envelope;
import org.locationtech.jts.geom.GeometryFactory;
import org.locationtech.jts.simplify.DouglasPeuckerSimplifier;

/**
 * A line or a closed ring, in steps of {@link WorldInts}; its chunks of some hundred points are simplified and painted each for itself, so that
 * no work grows with the square of a file. Immutable.
 */
final class Run {
    /** Points of a chunk; its last one is the next chunk's first. */
    static final int CHUNK = 256;

    private static final GeometryFactory GEOMETRY = new GeometryFactory();

    private final int[] xs;
    private final int[] ys;
    private final Envelope[] boxes;
    private final Envelope box = new Envelope();

    Run(int[] xs, int[] ys) {
        this.xs = xs;
        this.ys = ys;
        boxes = new Envelope[Math.max(1, (xs.length - 2) / CHUNK + 1)];
        for (int chunk = 0; chunk < boxes.length; chunk++) {
            boxes[chunk] = new Envelope();
            for (int i = from(chunk); i <= to(chunk); i++) {
                boxes[chunk].expandToInclude(xs[i], ys[i]);
            }
            box.expandToInclude(boxes[chunk]);
        }
    }

    int size() {
        return xs.length;
    }

    int x(int index) {
        return xs[index];
    }

    int y(int index) {
        return ys[index];
    }

    Envelope box() {
        return box;
    }

    int chunks() {
        return boxes.length;
    }

    Envelope box(int chunk) {
        return boxes[chunk];
    }

    int from(int chunk) {
        return chunk * CHUNK;
    }

    int to(int chunk) {
        return Math.min(xs.length - 1, (chunk + 1) * CHUNK);
    }

    /** The same within a tolerance, in steps; itself where that spares little. */
    Run simplified(double tolerance) {
        if (xs.length <= 2) {
            return this;
        }
        Ints x = new Ints();
        Ints y = new Ints();
        add(x, y, xs[0], ys[0]);
        for (int chunk = 0; chunk < boxes.length; chunk++) {
            if (boxes[chunk].getDiameter() > tolerance) {
                Coordinate[] kept = simplified(chunk, tolerance);
                for (int i = 1; i < kept.length - 1; i++) {
                    add(x, y, (int) kept[i].x, (int) kept[i].y);
                }
            }
            add(x, y, xs[to(chunk)], ys[to(chunk)]);
        }
        return x.size() > 0.8 * xs.length ? this : new Run(x.part(0, x.size()), y.part(0, y.size()));
    }

    private static void add(Ints xs, Ints ys, int x, int y) {
        xs.add(x);
        ys.add(y);
    }

    private Coordinate[] simplified(int chunk, double tolerance) {
        int from = from(chunk);
        Coordinate[] points = new Coordinate[to(chunk) - from + 1];
        for (int i = 0; i < points.length; i++) {
            points[i] = new Coordinate(xs[from + i], ys[from + i]);
        }
        return points.length <= 2
                ? points
                : DouglasPeuckerSimplifier.simplify(GEOMETRY.createLineString(points), tolerance)
                        .getCoordinates();
    }
}
