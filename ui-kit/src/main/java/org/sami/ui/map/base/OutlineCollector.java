package org.sami.ui.map.base;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.TimeUnit;

/** What is kept of a GeoJSON document, within a budget. */
final class OutlineCollector {
    private static final int CHECK_INTERVAL = 1024; // positions and members

    private final Path file;
    private final MapFileLimits budget;
    private final long begun;
    private final List<Run> lines = new ArrayList<>();
    private final List<List<Run>> polygons = new ArrayList<>();
    private final List<NamedPoint> names = new ArrayList<>();
    private CoordinateRuns current = new CoordinateRuns();
    private long points;
    private long outlines;
    private long namesBeyond;
    private int looks;
    private String full = "";

    /** The budget is used up: what was read until now is shown. */
    static final class Full extends RuntimeException {
        private static final long serialVersionUID = 1;

        Full() {
            super("full", null, false, false);
        }
    }

    OutlineCollector(Path file, MapFileLimits budget) {
        this.file = file;
        this.budget = budget;
        begun = budget.nanos().getAsLong();
    }

    /** The coordinates of the next geometry. */
    CoordinateRuns begin() {
        current = new CoordinateRuns();
        return current;
    }

    /**
     * Looks whether reading may go on.
     *
     * @throws Full if the budget is used up
     */
    void look() throws InterruptedReading {
        if (points + current.size() > budget.points()) {
            full("more than " + MapFileLimits.number(budget.points()) + " points");
        }
        if (++looks % CHECK_INTERVAL == 0) {
            if (Thread.currentThread().isInterrupted()) {
                throw new InterruptedReading(file + " was left");
            }
            if (budget.nanos().getAsLong() - begun > TimeUnit.SECONDS.toNanos(budget.seconds())) {
                full("more than can be read within " + budget.seconds() + " s");
            }
        }
    }

    private void full(String what) {
        full = what;
        throw new Full();
    }

    /** Takes what was read of the geometry at which the budget was used up, as lines. */
    void endInPart() throws GeoJsonFault {
        current.endHere();
        if (outlines < budget.outlines()
                && GeometryType.linesOf(current.depth()).isPresent()) {
            lines.addAll(current.lines());
        }
    }

    /** Keeps a geometry. */
    void take(GeometryType type, CoordinateRuns coordinates, String name) throws GeoJsonFault {
        if (coordinates.isEmpty()) {
            return; // allowed: nothing is there
        }
        if (coordinates.depth() != type.depth()) {
            throw new GeoJsonFault("positions of a " + type.word() + " lie in " + type.depth() + " lists, not in "
                    + coordinates.depth());
        }
        if (type.isPoints()) {
            coordinates.points().forEach(point -> {
                if (names.size() < budget.names()) {
                    names.add(new NamedPoint(name, point));
                } else {
                    namesBeyond++;
                }
            });
        } else if (type.isPolygons()) {
            polygons.addAll(coordinates.polygons());
            coordinates.polygons().forEach(rings -> outlines += rings.size());
            points += coordinates.size();
        } else {
            List<Run> more = coordinates.lines();
            lines.addAll(more);
            outlines += more.size();
            points += coordinates.size();
        }
        current = new CoordinateRuns();
        if (outlines >= budget.outlines()) {
            full("more than " + MapFileLimits.number(budget.outlines()) + " lines and outlines");
        }
    }

    /** How many points are kept with or without a name. */
    int named() {
        return names.size();
    }

    /** Names the points that came since there were so many and that have no name. */
    void name(int from, String name) {
        for (int i = from; i < names.size(); i++) {
            if (names.get(i).name().isEmpty()) {
                names.set(i, new NamedPoint(name, names.get(i).at()));
            }
        }
    }

    boolean isEmpty() {
        return lines.isEmpty() && polygons.isEmpty() && names.isEmpty();
    }

    Outlines outlines() {
        return new Outlines(List.copyOf(lines), List.copyOf(polygons));
    }

    List<NamedPoint> names() {
        return List.copyOf(names);
    }

    /** What of the file is not shown; empty where all is. */
    Optional<String> restriction() {
        if (!full.isEmpty()) {
            return Optional.of(file + " has " + full + ": the rest is not shown (shown are "
                    + MapFileLimits.number((long) lines.size() + polygons.size()) + " lines and areas)");
        }
        return namesBeyond == 0
                ? Optional.empty()
                : Optional.of(file + " has " + MapFileLimits.number(names.size() + namesBeyond)
                        + " single points: shown are the first " + MapFileLimits.number(names.size()));
    }

    /** Reading was left. */
    static final class InterruptedReading extends java.io.IOException {
        private static final long serialVersionUID = 1;

        InterruptedReading(String message) {
            super(message);
        }
    }
}
