package org.sami.crw.service.allocation;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.OptionalDouble;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.jspecify.annotations.Nullable;

/**
 * Moves work from boats whose charge does not last for their path to boats with charge left, one item after another, each time with the least
 * increase of all paths together. Ways home count where boats have to return and charges last for the whole. Where this does not help every boat, the
 * rest stays, and the division says so.
 */
final class RangeRepair {
    /** So many distances may be measured for it: less than a second's worth. */
    private static final long LIMIT = 40_000_000;

    private static final double ROUNDING_M = 1e-9;

    private final AllocationProblem problem;
    private final TravelCosts legs;
    private final boolean home;
    private final List<List<Integer>> shares = new ArrayList<>();
    private final double[] lengthM;

    /** Work that changes its boat. */
    private record Move(int from, int at, int to, int before, double costM) {}

    /** Paths as they were given; with {@code home} their lengths are those with the ways home. */
    private RangeRepair(AllocationProblem problem, TravelCosts legs, List<List<Integer>> given, boolean home) {
        this.problem = problem;
        this.legs = legs;
        this.home = home;
        given.forEach(share -> shares.add(new ArrayList<>(share)));
        lengthM = new double[given.size()];
        for (int boat = 0; boat < lengthM.length; boat++) {
            lengthM[boat] = lengthOf(boat);
        }
    }

    /** The shares, changed where a path is longer than its boat's charge lasts. */
    static List<List<Integer>> of(AllocationProblem problem, TravelCosts legs, List<List<Integer>> given) {
        if (problem.boats().stream().map(Candidate::rangeM).allMatch(OptionalDouble::isEmpty)) {
            return given;
        }
        if (problem.boats().stream().anyMatch(boat -> boat.home().isPresent())) {
            RangeRepair withWaysHome = new RangeRepair(problem, legs, given, true);
            withWaysHome.shorten();
            if (!withWaysHome.isAnyTooLong()) {
                return withWaysHome.shares;
            }
        }
        RangeRepair paths = new RangeRepair(problem, legs, given, false);
        paths.shorten();
        paths.sayWhatIsTooLong();
        return paths.shares;
    }

    private void shorten() {
        for (int boat = 0; boat < lengthM.length; boat++) {
            shorten(boat);
        }
    }

    private boolean isAnyTooLong() {
        return IntStream.range(0, lengthM.length)
                .anyMatch(boat -> !shares.get(boat).isEmpty() && leftM(boat) < 0);
    }

    private double leftM(int boat) {
        return problem.boats().get(boat).rangeM().orElse(Double.POSITIVE_INFINITY) - lengthM[boat];
    }

    private void shorten(int boat) {
        long end = legs.measured() + LIMIT / lengthM.length;
        while (leftM(boat) < 0 && legs.measured() < end) {
            Move move = cheapest(boat);
            if (move == null) {
                return;
            }
            int work = shares.get(boat).remove(move.at);
            shares.get(move.to).add(move.before, work);
            lengthM[boat] = lengthOf(boat);
            lengthM[move.to] = lengthOf(move.to);
        }
    }

    private double lengthOf(int boat) {
        double metres = legs.begun(boat);
        for (int i = 0; i < shares.get(boat).size(); i++) {
            metres += legs.leg(boat, stop(boat, i - 1), stop(boat, i));
        }
        return metres + homeM(boat, stop(boat, shares.get(boat).size() - 1));
    }

    private double homeM(int boat, int from) {
        return home ? legs.home(boat, from) : 0;
    }

    /** The work of a boat that others can do at the least cost, in metres of all paths together; null where nobody can. */
    private @Nullable Move cheapest(int from) {
        Move best = null;
        for (int at = 0; at < shares.get(from).size(); at++) {
            double savedM = savedM(from, at);
            int work = shares.get(from).get(at);
            for (int to = 0; savedM > ROUNDING_M && to < lengthM.length; to++) {
                if (to != from && legs.canDo(to, work)) {
                    best = cheaper(best, from, at, to, savedM);
                }
            }
        }
        return best;
    }

    private @Nullable Move cheaper(@Nullable Move known, int from, int at, int to, double savedM) {
        Move best = known;
        int work = shares.get(from).get(at);
        for (int before = 0; before <= shares.get(to).size(); before++) {
            double addedM = addedM(to, before, work);
            if (addedM <= leftM(to) && (best == null || addedM - savedM < best.costM)) {
                best = new Move(from, at, to, before, addedM - savedM);
            }
        }
        return best;
    }

    private double savedM(int boat, int at) {
        double metres = legs.leg(boat, stop(boat, at - 1), stop(boat, at));
        if (at + 1 < shares.get(boat).size()) {
            metres += legs.between(stop(boat, at), stop(boat, at + 1))
                    - legs.leg(boat, stop(boat, at - 1), stop(boat, at + 1));
            return metres;
        }
        return metres + homeM(boat, stop(boat, at)) - homeM(boat, stop(boat, at - 1));
    }

    private double addedM(int boat, int before, int work) {
        double metres = legs.leg(boat, stop(boat, before - 1), work);
        if (before < shares.get(boat).size()) {
            metres +=
                    legs.between(work, stop(boat, before)) - legs.leg(boat, stop(boat, before - 1), stop(boat, before));
            return metres;
        }
        return metres + homeM(boat, work) - homeM(boat, stop(boat, before - 1));
    }

    /** Below zero where the boat is free. */
    private int stop(int boat, int index) {
        return index < 0 ? -1 : shares.get(boat).get(index);
    }

    private void sayWhatIsTooLong() {
        String words = IntStream.range(0, lengthM.length)
                .filter(boat -> leftM(boat) < 0)
                .mapToObj(boat -> String.format(
                        Locale.ROOT,
                        "%s is to go %.0f m, and its charge is sure to last for %.0f m",
                        problem.boats().get(boat).boat(),
                        lengthM[boat],
                        lengthM[boat] + leftM(boat)))
                .collect(Collectors.joining("; "));
        if (!words.isEmpty()) {
            legs.fallShort(words + ": nobody else has charge left for it, and its battery is to be swapped on the way");
        }
    }
}
