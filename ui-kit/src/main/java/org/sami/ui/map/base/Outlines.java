package org.sami.ui.map.base;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.locationtech.jts.geom.Envelope;
import org.locationtech.jts.index.strtree.STRtree;

/** All outlines of a file as they are shown at one scale and at coarser ones down to the next: simplified, and found by where they lie. Immutable. */
final class Outlines {
    private static final double TOLERANCE_PX = 0.4;
    private static final double DOT_PX = 0.75; // a smaller outline is shown as a dot

    /** A part of a line. */
    record Stroke(Run run, int chunk) {}

    private final List<Run> lines;
    private final List<List<Run>> polygons;
    private final STRtree strokes = new STRtree();
    private final STRtree fills = new STRtree();
    private final int points;

    /**
     * Outlines as they were read.
     *
     * @param polygons the rings of each, closed
     */
    Outlines(List<Run> lines, List<List<Run>> polygons) {
        this.lines = lines;
        this.polygons = polygons;
        int count = 0;
        for (Run line : lines) {
            count += index(line);
        }
        for (List<Run> rings : polygons) {
            fills.insert(rings.get(0).box(), rings);
            for (Run ring : rings) {
                count += index(ring);
            }
        }
        points = count;
        strokes.build();
        fills.build();
    }

    private int index(Run run) {
        for (int chunk = 0; chunk < run.chunks(); chunk++) {
            strokes.insert(run.box(chunk), new Stroke(run, chunk));
        }
        return run.size();
    }

    int points() {
        return points;
    }

    /** How many lines and polygons there are. */
    int count() {
        return lines.size() + polygons.size();
    }

    /** The box around all of them; none where there are none. */
    Optional<Envelope> box() {
        Envelope box = new Envelope();
        lines.forEach(line -> box.expandToInclude(line.box()));
        polygons.forEach(rings -> box.expandToInclude(rings.get(0).box()));
        return box.isNull() ? Optional.empty() : Optional.of(box);
    }

    /** The parts of lines and rings that may be seen in a box. */
    @SuppressWarnings("unchecked") // the index has no type for what was put into it
    List<Stroke> strokes(Envelope box) {
        return strokes.query(box);
    }

    /** The polygons, each with its rings, that may be seen in a box. */
    @SuppressWarnings("unchecked")
    List<List<Run>> fills(Envelope box) {
        return fills.query(box);
    }

    /**
     * The same for a scale at which the world is so many pixels wide; ends when its thread is interrupted.
     *
     * @throws InterruptedException if it was
     */
    Outlines simplified(double worldPx) throws InterruptedException {
        double px = WorldInts.stepsPerPx(worldPx);
        Dots dots = new Dots(px);
        List<Run> simpler = new ArrayList<>();
        for (Run line : lines) {
            stopIfInterrupted();
            if (dots.isDot(line)) {
                dots.add(line);
            } else {
                simpler.add(line.simplified(TOLERANCE_PX * px));
            }
        }
        List<List<Run>> areas = new ArrayList<>();
        for (List<Run> rings : polygons) {
            stopIfInterrupted();
            if (dots.isDot(rings.get(0))) {
                dots.add(rings.get(0));
            } else {
                areas.add(rings.stream()
                        .filter(ring -> !dots.isDot(ring))
                        .map(ring -> ring.simplified(TOLERANCE_PX * px))
                        .toList());
            }
        }
        simpler.addAll(dots.runs);
        return new Outlines(simpler, areas);
    }

    private static void stopIfInterrupted() throws InterruptedException {
        if (Thread.interrupted()) {
            throw new InterruptedException("left");
        }
    }

    /** Outlines too small for the scale: one stands for all that would share a pixel. */
    private static final class Dots {
        private final double px;
        private final Set<Long> taken = new HashSet<>();
        private final List<Run> runs = new ArrayList<>();

        Dots(double px) {
            this.px = px;
        }

        boolean isDot(Run run) {
            return run.box().getWidth() < DOT_PX * px && run.box().getHeight() < DOT_PX * px;
        }

        void add(Run run) {
            long x = (long) Math.floor(run.x(0) / px);
            long y = (long) Math.floor(run.y(0) / px);
            if (taken.add((x << 32) ^ (y & 0xFFFFFFFFL))) {
                runs.add(
                        run.size() == 2
                                ? run
                                : new Run(new int[] {run.x(0), run.x(0)}, new int[] {run.y(0), run.y(0)}));
            }
        }
    }
}
