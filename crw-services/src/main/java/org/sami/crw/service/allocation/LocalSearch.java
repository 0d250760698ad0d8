package org.sami.crw.service.allocation;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * Improves the paths of a division by small changes until none helps. Parts of up to three stops move to another place on the same or another path,
 * in either direction; parts of a path are reversed; two boats exchange the rests of their paths. In the result no path crosses another or itself, if
 * paths may exchange rests freely and the criterion is the least sum: a crossing of straight legs can always be replaced by something shorter.
 *
 * <p>The search takes the first change that helps, in a fixed order, so equal problems have equal answers. A round costs O(L²) for L locations; the
 * search stops at a budget of distances, so that large problems end in time, with what was reached.
 */
final class LocalSearch {
    /** About half a second's worth. */
    private static final long BUDGET = 40_000_000;

    private static final int LONGEST_PART = 3;

    private final TravelCosts legs;
    private final Objective objective;
    private final long until;
    private final List<Path> paths = new ArrayList<>();

    LocalSearch(TravelCosts legs, Objective objective, List<List<Integer>> shares) {
        this.legs = legs;
        this.objective = objective;
        until = legs.measured() + BUDGET;
        for (int boat = 0; boat < shares.size(); boat++) {
            paths.add(new Path(boat, shares.get(boat)));
        }
    }

    /** Searches, and returns what it found. */
    List<List<Integer>> run() {
        boolean better = true;
        while (better && inBudget()) {
            better = false;
            for (Path path : paths) {
                better |= turn(path);
                for (Path other : paths) {
                    better |= path == other ? moveWithin(path) : moveTo(path, other);
                    better |= path.boat < other.boat && exchangeRests(path, other);
                }
            }
        }
        return paths.stream().map(Path::stops).toList();
    }

    private boolean inBudget() {
        return legs.measured() < until;
    }

    /** Turns parts of a path round, while that makes it shorter. */
    private boolean turn(Path path) {
        boolean any = false;
        for (int from = 0; from < path.size && inBudget(); from++) {
            for (int to = from + 1; to < path.size; to++) {
                double change = path.leg(from - 1, to) - path.leg(from - 1, from);
                if (to + 1 < path.size) {
                    change += path.leg(from, to + 1) - path.leg(to, to + 1);
                }
                if (isBetter(path, path.length() + change)) {
                    path.turn(from, to);
                    any = true;
                }
            }
        }
        return any;
    }

    private boolean moveWithin(Path path) {
        boolean any = false;
        for (int part = 1; part <= LONGEST_PART; part++) {
            for (int from = 0; from + part <= path.size && inBudget(); from++) {
                any |= moveWithin(path, from, part);
            }
        }
        return any;
    }

    private boolean moveWithin(Path path, int from, int part) {
        double without = path.lengthWithout(from, part);
        int last = from + part - 1;
        for (int before = 0; before <= path.size; before++) {
            if (before >= from && before <= last + 1) {
                continue;
            }
            for (boolean turned : new boolean[] {false, true}) {
                double with = without
                        + path.inner(from, last)
                        + path.insertion(before, path.stops[turned ? last : from], path.stops[turned ? from : last]);
                if (isBetter(path, with)) {
                    int[] moved = path.cut(from, part);
                    path.insert(before > last ? before - part : before, turned ? turned(moved) : moved);
                    return true;
                }
            }
        }
        return false;
    }

    private boolean moveTo(Path source, Path target) {
        boolean any = false;
        for (int part = 1; part <= LONGEST_PART; part++) {
            for (int from = 0; from + part <= source.size && inBudget(); from++) {
                if (canDo(target.boat, source, from, from + part)) {
                    any |= moveTo(source, from, part, target);
                }
            }
        }
        return any;
    }

    private boolean moveTo(Path source, int from, int part, Path target) {
        double without = source.lengthWithout(from, part);
        int last = from + part - 1;
        double inner = source.inner(from, last);
        for (int before = 0; before <= target.size; before++) {
            for (boolean turned : new boolean[] {false, true}) {
                double with = target.length()
                        + inner
                        + target.insertion(
                                before, source.stops[turned ? last : from], source.stops[turned ? from : last]);
                if (isBetter(source, without, target, with)) {
                    int[] moved = source.cut(from, part);
                    target.insert(before, turned ? turned(moved) : moved);
                    return true;
                }
            }
        }
        return false;
    }

    /** Two boats go on, each from some stop, with what the other would have done. */
    private boolean exchangeRests(Path a, Path b) {
        for (int i = 0; i <= a.size && inBudget(); i++) {
            for (int j = 0; j <= b.size; j++) {
                double newA = a.lengthTo(i) + (j < b.size ? a.legTo(i - 1, b.stops[j]) + b.rest(j) : 0);
                double newB = b.lengthTo(j) + (i < a.size ? b.legTo(j - 1, a.stops[i]) + a.rest(i) : 0);
                if (isBetter(a, newA, b, newB) && canDo(b.boat, a, i, a.size) && canDo(a.boat, b, j, b.size)) {
                    int[] restA = a.cut(i, a.size - i);
                    int[] restB = b.cut(j, b.size - j);
                    a.insert(i, restB);
                    b.insert(j, restA);
                    return true;
                }
            }
        }
        return false;
    }

    private boolean isBetter(Path path, double lengthM) {
        return objective.better(path.cost(path.length()), 0, path.cost(lengthM), 0);
    }

    private boolean isBetter(Path a, double lengthOfA, Path b, double lengthOfB) {
        return objective.better(a.cost(a.length()), b.cost(b.length()), a.cost(lengthOfA), b.cost(lengthOfB));
    }

    private boolean canDo(int boat, Path source, int from, int to) {
        for (int i = from; i < to; i++) {
            if (!legs.canDo(boat, source.stops[i])) {
                return false;
            }
        }
        return true;
    }

    private static int[] turned(int[] part) {
        int[] turned = new int[part.length];
        for (int i = 0; i < part.length; i++) {
            turned[i] = part[part.length - 1 - i];
        }
        return turned;
    }

    /** The path of one boat, with its length up to each stop. */
    private final class Path {
        private final int boat;
        private int[] stops;
        private int size;
        /** Length up to and including each stop. */
        private double[] lengthTo;

        Path(int boat, List<Integer> share) {
            this.boat = boat;
            stops = share.stream().mapToInt(Integer::intValue).toArray();
            size = stops.length;
            lengthTo = new double[size];
            measure(0);
        }

        List<Integer> stops() {
            return Arrays.stream(stops, 0, size).boxed().toList();
        }

        double length() {
            return lengthTo(size);
        }

        double cost(double lengthM) {
            return legs.cost(objective.isByTime(), boat, lengthM);
        }

        /** Length of the first stops, what was begun included. */
        double lengthTo(int count) {
            return count == 0 ? legs.begun(boat) : lengthTo[count - 1];
        }

        /** Length from a stop to the end. */
        double rest(int from) {
            return lengthTo[size - 1] - lengthTo[from];
        }

        double leg(int from, int to) {
            return legTo(from, stops[to]);
        }

        double legTo(int from, int work) {
            return legs.leg(boat, from < 0 ? -1 : stops[from], work);
        }

        double inner(int first, int last) {
            return lengthTo[last] - lengthTo[first];
        }

        double lengthWithout(int from, int part) {
            int next = from + part;
            double length = length() - inner(from, next - 1) - leg(from - 1, from);
            return next < size ? length - leg(next - 1, next) + leg(from - 1, next) : length;
        }

        /** What it costs to go by some work before a stop; its own inner length not included. */
        double insertion(int before, int first, int last) {
            double cost = legTo(before - 1, first);
            return before < size ? cost + legs.between(last, stops[before]) - leg(before - 1, before) : cost;
        }

        void turn(int from, int to) {
            for (int i = from, j = to; i < j; i++, j--) {
                int kept = stops[i];
                stops[i] = stops[j];
                stops[j] = kept;
            }
            measure(from);
        }

        int[] cut(int from, int part) {
            int[] cut = Arrays.copyOfRange(stops, from, from + part);
            System.arraycopy(stops, from + part, stops, from, size - from - part);
            size -= part;
            measure(from);
            return cut;
        }

        void insert(int before, int[] part) {
            if (size + part.length > stops.length) {
                stops = Arrays.copyOf(stops, 2 * (size + part.length));
                lengthTo = Arrays.copyOf(lengthTo, stops.length);
            }
            System.arraycopy(stops, before, stops, before + part.length, size - before);
            System.arraycopy(part, 0, stops, before, part.length);
            size += part.length;
            measure(before);
        }

        private void measure(int from) {
            for (int i = from; i < size; i++) {
                lengthTo[i] = lengthTo(i) + leg(i - 1, i);
            }
        }
    }
}
