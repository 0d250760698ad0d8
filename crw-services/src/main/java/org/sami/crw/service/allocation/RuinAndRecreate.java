package org.sami.crw.service.allocation;

import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;

/**
 * Searches for a better division by ruin and recreate (G. Schrimpf et al., Record breaking optimization results using the ruin and recreate
 * principle, 2000). Each try removes strings of neighbouring stops from some paths and inserts each stop where it costs least; simulated annealing
 * decides whether to accept the result. Strings, order and blinks are those of J. Christiaens, G. Vanden Berghe, Slack induction by string removals
 * for vehicle routing problems, 2020, called SISR below.
 *
 * <p>Tries are compared by a norm of all paths with a growing exponent: most changes leave the longest path as it is.
 *
 * <p>The search ends after a number of tried positions, with the same random numbers each time: equal problems have equal answers.
 */
final class RuinAndRecreate {
    /** For more work the table of distances is too large, and the tried positions are too few to gain much. */
    static final int MOST_WORK = 1000;

    /** The most positions that are tried: some 0.4 s on a core of 2020. */
    private static final long MOST_POSITIONS = 60_000_000;

    /** The most positions for each location: small problems need fewer. */
    private static final long POSITIONS_FOR_EACH = 600_000;

    private static final long SEED = 20_130_701; // any number does

    /** Temperature and exponent change so often during a search. */
    private static final int STEPS = 200;

    /** The factors of acceptance come from a table: logarithms would cost more than a try. */
    private static final int DRAWS = 256;

    private static final double MEAN_REMOVED = 10; // as in SISR
    private static final double LONGEST_STRING = 10; // as in SISR
    private static final int MOST_NEIGHBOURS = 100;

    /** Mean number of positions of which one is skipped, as in SISR: otherwise every try would insert at the same places. */
    private static final int BLINK_EVERY = 100;

    private final SearchedPaths paths;
    private final TravelCosts legs;
    private final Objective objective;
    private final SplittableRandom random = new SplittableRandom(SEED);
    private final int[][] neighbours;
    private final double[] nearestBoatM;
    private final int[] removed;
    private final double[] accepted = new double[DRAWS];
    private final long positions; // to try
    private long tried;
    private int untilBlink = 1;
    private int count; // of what is removed
    private double best;
    private List<List<Integer>> bestShares;

    RuinAndRecreate(AllocationProblem problem, TravelCosts legs, Objective objective, List<List<Integer>> shares) {
        this.legs = legs;
        this.objective = objective;
        paths = new SearchedPaths(problem, legs, objective.isByTime(), shares);
        removed = new int[paths.workCount()];
        neighbours = new int[paths.workCount()][];
        nearestBoatM = new double[paths.workCount()];
        for (int work = 0; work < neighbours.length; work++) {
            neighbours[work] = neighboursOf(work);
            nearestBoatM[work] = nearestBoatM(work);
        }
        positions = Math.min(MOST_POSITIONS, POSITIONS_FOR_EACH * paths.workCount());
        bestShares = shares;
        best = objective.value(paths);
    }

    /** The shares, changed where that is better: never worse than those that were given. */
    List<List<Integer>> run() {
        for (int step = 0; step < STEPS && paths.workCount() > 1; step++) {
            double part = (double) step / (STEPS - 1);
            int doublings = objective.doublings(part);
            paths.weighByPower(doublings);
            coolTo(objective.temperature(part) * (1 << doublings));
            while (tried < positions * (step + 1) / STEPS) {
                tryChange();
            }
        }
        return bestShares;
    }

    /** Computes by which factor a try may raise the norm, for equally probable draws. */
    private void coolTo(double temperature) {
        for (int draw = 0; draw < DRAWS; draw++) {
            accepted[draw] = StrictMath.exp(-temperature * StrictMath.log((draw + 0.5) / DRAWS));
        }
    }

    /** Changes the paths, and keeps the change if it is accepted. */
    private void tryChange() {
        double before = paths.totalWeight();
        long triedBefore = tried;
        paths.checkpoint();
        ruin();
        if (!recreate() || paths.totalWeight() > before * accepted[random.nextInt(DRAWS)]) {
            paths.rollBack();
        } else if (objective.value(paths) < best) {
            best = objective.value(paths);
            bestShares = paths.shares();
        }
        tried++;
        legs.count(tried - triedBefore);
    }

    /** Removes one string of stops from each of some paths that lie near one another. */
    private void ruin() {
        int first = seed();
        double longest = Math.min(LONGEST_STRING, Math.max(1, (double) paths.workCount() / paths.boatCount()));
        int strings = (int) (1 + random.nextDouble() * (4 * MEAN_REMOVED / (1 + longest) - 1));
        count = 0;
        removeString(first, longest);
        for (int i = 0; i < neighbours[first].length && strings > 1; i++) {
            int work = neighbours[first][i];
            if (paths.boatOf(work) >= 0 && !paths.isChanged(paths.boatOf(work))) {
                removeString(work, longest);
                strings--;
            }
        }
    }

    /** Work around which to ruin: every other time some of the heaviest path. */
    private int seed() {
        int heaviest = paths.heaviest();
        return random.nextBoolean() && paths.size(heaviest) > 0
                ? paths.stop(heaviest, random.nextInt(paths.size(heaviest)))
                : random.nextInt(paths.workCount());
    }

    /** Removes a string that holds some work; every other time some stops in the middle of it stay ("split string" of SISR). */
    private void removeString(int work, double longest) {
        int boat = paths.boatOf(work);
        int size = paths.size(boat);
        int length = Math.min(size, (int) (1 + random.nextDouble() * Math.min(longest, size)));
        int kept = 0;
        if (length > 1 && length < size && random.nextBoolean()) {
            do {
                kept++;
            } while (length + kept < size && random.nextBoolean());
        }
        int window = length + kept;
        int earliest = Math.max(0, paths.indexOf(work) - window + 1);
        int latest = Math.min(paths.indexOf(work), size - window);
        int from = earliest + random.nextInt(latest - earliest + 1);
        int keptFrom = from + (kept == 0 ? 0 : random.nextInt(length));
        count = paths.remove(boat, from, from + window, keptFrom, kept, removed, count);
    }

    /** Inserts all that was removed where it adds least weight, one after another; false if there was no position for one. */
    private boolean recreate() {
        order();
        for (int i = 0; i < count; i++) {
            if (!insertCheapest(removed[i])) {
                return false;
            }
        }
        return true;
    }

    private boolean insertCheapest(int work) {
        double least = Double.POSITIVE_INFINITY;
        int bestBoat = -1;
        int bestBefore = 0;
        for (int boat = 0; boat < paths.boatCount(); boat++) {
            if (paths.canDo(boat, work)) {
                int before = cheapestPosition(boat, work);
                double added = before < 0
                        ? Double.POSITIVE_INFINITY
                        : paths.addedWeight(boat, paths.addedM(boat, before, work));
                if (added < least) {
                    least = added;
                    bestBoat = boat;
                    bestBefore = before;
                }
            }
        }
        if (bestBoat >= 0) {
            paths.insert(bestBoat, bestBefore, work);
        }
        return bestBoat >= 0;
    }

    /** The index before which work makes a path least longer; below zero if all positions were passed over. */
    private int cheapestPosition(int boat, int work) {
        int size = paths.size(boat);
        double least = Double.POSITIVE_INFINITY;
        int best = -1;
        for (int before = 0; before <= size; before++) {
            double addedM = paths.addedM(boat, before, work);
            if (addedM < least && !isBlink()) {
                least = addedM;
                best = before;
            }
        }
        tried += size + 1;
        return best;
    }

    /** Whether a position is passed over. */
    private boolean isBlink() {
        if (--untilBlink > 0) {
            return false;
        }
        untilBlink = 1 + random.nextInt(2 * BLINK_EVERY);
        return true;
    }

    /** Orders the removed stops: in 4 of 7 tries at random, in 2 the stops farthest from all boats first, in 1 last (as in SISR). */
    private void order() {
        int draw = random.nextInt(7);
        if (draw < 4) {
            shuffle();
        } else {
            sortByDistance(draw < 6);
        }
    }

    private void shuffle() {
        for (int i = count - 1; i > 0; i--) {
            swap(i, random.nextInt(i + 1));
        }
    }

    private void sortByDistance(boolean farthestFirst) {
        double sign = farthestFirst ? 1 : -1;
        for (int i = 1; i < count; i++) {
            for (int j = i; j > 0 && sign * nearestBoatM[removed[j]] > sign * nearestBoatM[removed[j - 1]]; j--) {
                swap(j, j - 1);
            }
        }
    }

    private void swap(int i, int j) {
        int kept = removed[i];
        removed[i] = removed[j];
        removed[j] = kept;
    }

    /** The nearest other work, the nearest first. */
    private int[] neighboursOf(int work) {
        long[] byDistance = new long
                [paths.workCount()]; // distance in the upper half, whose bits are in its order, index in the lower
        for (int other = 0; other < byDistance.length; other++) {
            float distanceM = other == work ? Float.MAX_VALUE : (float) paths.legM(work, other);
            byDistance[other] = (long) Float.floatToIntBits(distanceM) << Integer.SIZE | other;
        }
        Arrays.sort(byDistance);
        return Arrays.stream(byDistance)
                .limit(Math.min(MOST_NEIGHBOURS, paths.workCount() - 1))
                .mapToInt(packed -> (int) packed)
                .toArray();
    }

    /** How far the nearest boat is from some work. */
    private double nearestBoatM(int work) {
        double least = Double.POSITIVE_INFINITY;
        for (int boat = 0; boat < paths.boatCount(); boat++) {
            least = Math.min(least, paths.legM(paths.workCount() + boat, work));
        }
        return least;
    }
}
