package org.sami.crw.service.allocation;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.sami.crw.service.Interruption;
import org.sami.crw.service.LocalPlane;
import org.sami.crw.service.path.TurningCircle;
import org.sami.crw.service.path.WayLengths;
import org.sami.spn.value.GeoPoint;

/**
 * Distances between boats and work by their indices in a problem: straight on a plane, or of ways around what is in between. Counts how many it was asked for: the
 * measure of how much an algorithm computes, the same on every machine.
 */
final class TravelCosts {
    private static final long LOOK_MASK = (1 << 16) - 1;
    private static final double BEYOND_RANGE = 9;

    private final double[] boatX;
    private final double[] boatY;
    private final double[] homeX; // no number where the way home does not count
    private final double[] homeY;
    private final double[] begunM;
    private final double[] rangeM;
    private final double[] slowness;
    private final double[] radiusM; // of the narrowest turn
    private final boolean hasTurns;
    private final double[] x;
    private final double[] y;
    private final AllocationProblem problem;
    private final double[][] wayM; // as the matrix; empty where distances are straight
    private long measured;
    private Optional<String> shortfall = Optional.empty();

    TravelCosts(AllocationProblem problem) {
        this.problem = problem;
        List<Candidate> boats = problem.boats();
        LocalPlane plane = new LocalPlane(
                boats.isEmpty() ? GeoPoint.of(0, 0) : boats.get(0).at());
        boatX = boats.stream().mapToDouble(boat -> plane.x(boat.freeAt())).toArray();
        boatY = boats.stream().mapToDouble(boat -> plane.y(boat.freeAt())).toArray();
        homeX = boats.stream()
                .mapToDouble(boat -> boat.home().map(plane::x).orElse(Double.NaN))
                .toArray();
        homeY = boats.stream()
                .mapToDouble(boat -> boat.home().map(plane::y).orElse(Double.NaN))
                .toArray();
        begunM = boats.stream()
                .mapToDouble(boat -> problem.lengthM(
                        boat, boat.begun().stream().map(WorkItem::location).toList()))
                .toArray();
        rangeM = boats.stream()
                .mapToDouble(boat -> boat.rangeM().orElse(Double.POSITIVE_INFINITY))
                .toArray();
        slowness = boats.stream().mapToDouble(problem::slowness).toArray();
        radiusM = boats.stream().mapToDouble(Candidate::turningRadiusM).toArray();
        hasTurns = Arrays.stream(radiusM).anyMatch(metres -> metres > 0);
        x = problem.work().stream().mapToDouble(one -> plane.x(one.location())).toArray();
        y = problem.work().stream().mapToDouble(one -> plane.y(one.location())).toArray();
        wayM = problem.ways()
                .filter(lengths -> !lengths.isStraight())
                .map(this::wayM)
                .orElse(new double[0][]);
        problem.ways().flatMap(WayLengths::shortfall).ifPresent(this::fallShort);
    }

    private double[][] wayM(WayLengths lengths) {
        double[][] metres = new double[x.length + boatX.length][x.length];
        for (int to = 0; to < x.length; to++) {
            GeoPoint end = problem.work().get(to).location();
            for (int from = 0; from < x.length; from++) {
                metres[from][to] = lengths.lengthM(problem.work().get(from).location(), end);
            }
            for (int boat = 0; boat < boatX.length; boat++) {
                metres[x.length + boat][to] =
                        lengths.lengthM(problem.boats().get(boat).freeAt(), end);
            }
        }
        return metres;
    }

    /** Whether a boat offers what some work needs and can get to it. */
    boolean canDo(int boat, int work) {
        return problem.boats().get(boat).canDo(problem.work().get(work))
                && (wayM.length == 0 || wayM[x.length + boat][work] < Double.POSITIVE_INFINITY);
    }

    /** Length of what a boat has begun; it counts as part of its path. */
    double begun(int boat) {
        return begunM[boat];
    }

    /** What a path of a length costs its boat: what is longer than its charge lasts for counts tenfold. By time, its time as metres of the fastest boat. */
    double cost(boolean byTime, int boat, double lengthM) {
        double metres = lengthM <= rangeM[boat] ? lengthM : lengthM + BEYOND_RANGE * (lengthM - rangeM[boat]);
        return byTime ? timeM(boat, metres) : metres;
    }

    /** The time that a boat takes for a path of a length, as metres of the fastest boat. */
    double timeM(int boat, double lengthM) {
        return lengthM * slowness[boat];
    }

    /** The length of a path for which a boat takes a time, which is given as metres of the fastest boat. */
    double lengthM(int boat, double timeM) {
        return timeM / slowness[boat];
    }

    /** Whether any boat has a turning circle. */
    boolean hasTurns() {
        return hasTurns;
    }

    /**
     * What a boat drives in addition at a stop of its path, in metres: as if its ways there and on were straight.
     *
     * @param from the stop before; below zero where the boat is free
     */
    double turn(int boat, int from, int at, int to) {
        if (radiusM[boat] == 0) {
            return 0;
        }
        count();
        double fromX = from < 0 ? boatX[boat] : x[from];
        double fromY = from < 0 ? boatY[boat] : y[from];
        return radiusM[boat] * TurningCircle.perRadius(fromX, fromY, x[at], y[at], x[to], y[to]);
    }

    /** What a boat drives in addition at all stops of a path where it turns, in metres. */
    double turnsM(int boat, List<Integer> path) {
        double metres = 0;
        for (int i = 1; i < path.size(); i++) {
            metres += turn(boat, i == 1 ? -1 : path.get(i - 2), path.get(i - 1), path.get(i));
        }
        return metres;
    }

    /** The length of a boat's path without its turns, in metres. */
    double lengthM(int boat, List<Integer> path) {
        double metres = begunM[boat];
        for (int i = 0; i < path.size(); i++) {
            metres += leg(boat, i == 0 ? -1 : path.get(i - 1), path.get(i));
        }
        return metres;
    }

    private void count() {
        if ((++measured & LOOK_MASK) == 0) {
            Interruption.check();
        }
    }

    /** Counts distances that were taken from the matrix. */
    void count(long distances) {
        long before = measured;
        measured += distances;
        if ((before ^ measured) > LOOK_MASK) {
            Interruption.check();
        }
    }

    /** All distances to work: from work, then from where each boat is free. */
    double[][] matrix() {
        double[][] matrix = new double[x.length + boatX.length][x.length];
        for (int to = 0; to < x.length; to++) {
            for (int from = 0; from < x.length; from++) {
                matrix[from][to] = between(from, to);
            }
            for (int boat = 0; boat < boatX.length; boat++) {
                matrix[x.length + boat][to] = first(boat, to);
            }
        }
        return matrix;
    }

    /** The division came to a limit; what became of the rest, in words. */
    void fallShort(String words) {
        shortfall = Optional.of(shortfall.map(before -> before + "; ").orElse("") + words);
    }

    Optional<String> shortfall() {
        return shortfall;
    }

    /** From where a boat is free to some work. */
    double first(int boat, int to) {
        count();
        return wayM.length > 0 ? wayM[x.length + boat][to] : distance(boatX[boat], boatY[boat], x[to], y[to]);
    }

    double between(int from, int to) {
        count();
        return wayM.length > 0 ? wayM[from][to] : distance(x[from], y[from], x[to], y[to]);
    }

    /** From a stop of a boat's path; {@code from} below zero is where the boat is free. */
    double leg(int boat, int from, int to) {
        return from < 0 ? first(boat, to) : between(from, to);
    }

    /** From a stop of a boat's path straight home; 0 where that does not count. */
    double home(int boat, int from) {
        count();
        if (Double.isNaN(homeX[boat])) {
            return 0;
        }
        return from < 0
                ? distance(boatX[boat], boatY[boat], homeX[boat], homeY[boat])
                : distance(x[from], y[from], homeX[boat], homeY[boat]);
    }

    long measured() {
        return measured;
    }

    private static double distance(double fromX, double fromY, double toX, double toY) {
        double dx = toX - fromX;
        double dy = toY - fromY;
        return Math.sqrt(dx * dx + dy * dy);
    }
}
