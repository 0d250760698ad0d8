package org.sami.crw.service.allocation;

import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;

/**
 * Searches for a better division: again and again takes stops that lie near one another out of some paths, puts each where it costs least, and
 * keeps what is better, or by simulated annealing a little worse (G. Schrimpf et al., Record breaking optimization results using the ruin and
 * recreate principle, 2000; what is taken out are rows of stops as in J. Christiaens, G. Vanden Berghe, Slack induction by string removals
 * for vehicle routing problems, 2020).
 *
 * <p>A longest path is no good guide, as most changes leave it as it is: what is compared is a norm of all paths, whose exponent grows.
 *
 * <p>Ends after a number of tried places, and its random numbers are always the same ones: equal problems have equal answers.
 */
final class RuinAndRecreate {
    /** For more work the table of distances is too large, and the places are too few to gain much. */
    static final int MOST_WORK = 1000;

    /** Some 0.4 s on a core of 2020. */
    private static final long PLACES = 60_000_000;

    private static final long PLACES_FOR_A_WORK = 600_000;
    private static final long SEED = 20_130_701;

    /** What is accepted falls from the first to the last in this many steps, relative to the norm. */
    private static final int STEPS = 200;

    private static final int DRAWS = 256;
    private static final double MEAN_TAKEN = 10;
    private static final double LONGEST_ROW = 10;
    private static final int MOST_NEAR = 100;

    /** Once in so many places, on average, one is overlooked. */
    private static final int OVERLOOKED = 100;

    private final SearchedPaths paths;
    private final DistanceTable legs;
    private final Objective objective;
    private final SplittableRandom random = new SplittableRandom(SEED);
    private final int[][] near;
    private final double[] awayM;
    private final int[] taken;
    private final double[] accepted = new double[DRAWS];
    private final long places;
    private long tried;
    private int untilOverlooked = 1;
    private int count;
    private double best;
    private List<List<Integer>> bestShares;

    RuinAndRecreate(AllocationProblem problem, DistanceTable legs, Objective objective, List<List<Integer>> shares) {
        this.legs = legs;
        this.objective = objective;
        paths = new SearchedPaths(problem, legs, shares);
        taken = new int[paths.works()];
        near = new int[paths.works()][];
        awayM = new double[paths.works()];
        for (int work = 0; work < near.length; work++) {
            near[work] = nearTo(work);
            awayM[work] = awayM(work);
        }
        places = Math.min(PLACES, PLACES_FOR_A_WORK * paths.works());
        bestShares = shares;
        best = objective.value(paths);
    }

    /** The shares, changed where that is better: never worse than those that were given. */
    List<List<Integer>> run() {
        for (int step = 0; step < STEPS && paths.works() > 1; step++) {
            double part = (double) step / (STEPS - 1);
            int doublings = objective.doublings(part);
            paths.weigh(doublings);
            coolTo(objective.temperature(part) * (1 << doublings));
            while (tried < places * (step + 1) / STEPS) {
                change();
            }
        }
        return bestShares;
    }

    /** What the norm may be multiplied with, for each draw, all equally probable. */
    private void coolTo(double temperature) {
        for (int draw = 0; draw < DRAWS; draw++) {
            accepted[draw] = StrictMath.exp(-temperature * StrictMath.log((draw + 0.5) / DRAWS));
        }
    }

    private void change() {
        double before = paths.weight();
        long triedBefore = tried;
        paths.mark();
        takeOut();
        if (!putBack() || paths.weight() > before * accepted[random.nextInt(DRAWS)]) {
            paths.takeBack();
        } else if (objective.value(paths) < best) {
            best = objective.value(paths);
            bestShares = paths.shares();
        }
        tried++;
        legs.count(tried - triedBefore);
    }

    /** Takes rows of stops out of some paths that lie near one another, one row of each. */
    private void takeOut() {
        int first = someWork();
        double longest = Math.min(LONGEST_ROW, Math.max(1, (double) paths.works() / paths.boats()));
        int rows = (int) (1 + random.nextDouble() * (4 * MEAN_TAKEN / (1 + longest) - 1));
        count = 0;
        takeRow(first, longest);
        for (int i = 0; i < near[first].length && rows > 1; i++) {
            int work = near[first][i];
            if (paths.boatOf(work) >= 0 && !paths.isChanged(paths.boatOf(work))) {
                takeRow(work, longest);
                rows--;
            }
        }
    }

    /** Every other time work of the heaviest path. */
    private int someWork() {
        int heaviest = paths.heaviest();
        return random.nextBoolean() && paths.size(heaviest) > 0
                ? paths.stop(heaviest, random.nextInt(paths.size(heaviest)))
                : random.nextInt(paths.works());
    }

    /** Every other time some stops in the row stay. */
    private void takeRow(int work, double longest) {
        int boat = paths.boatOf(work);
        int size = paths.size(boat);
        int row = Math.min(size, (int) (1 + random.nextDouble() * Math.min(longest, size)));
        int kept = 0;
        if (row > 1 && row < size && random.nextBoolean()) {
            do {
                kept++;
            } while (row + kept < size && random.nextBoolean());
        }
        int whole = row + kept;
        int earliest = Math.max(0, paths.indexOf(work) - whole + 1);
        int latest = Math.min(paths.indexOf(work), size - whole);
        int from = earliest + random.nextInt(latest - earliest + 1);
        int keptFrom = from + (kept == 0 ? 0 : random.nextInt(row));
        count = paths.takeOut(boat, from, from + whole, keptFrom, kept, taken, count);
    }

    /** Puts all that was taken out where it weighs least, one after another; false where some work found no place. */
    private boolean putBack() {
        order();
        for (int i = 0; i < count; i++) {
            if (!putBack(taken[i])) {
                return false;
            }
        }
        return true;
    }

    private boolean putBack(int work) {
        double least = Double.POSITIVE_INFINITY;
        int bestBoat = -1;
        int bestBefore = 0;
        for (int boat = 0; boat < paths.boats(); boat++) {
            if (paths.canDo(boat, work)) {
                int before = cheapestPlace(boat, work);
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

    /** Before which stop work makes a path least longer; below zero where all places were overlooked. */
    private int cheapestPlace(int boat, int work) {
        int size = paths.size(boat);
        double least = Double.POSITIVE_INFINITY;
        int best = -1;
        for (int before = 0; before <= size; before++) {
            double addedM = paths.addedM(boat, before, work);
            if (addedM < least && !isOverlooked()) {
                least = addedM;
                best = before;
            }
        }
        tried += size + 1;
        return best;
    }

    private boolean isOverlooked() {
        if (--untilOverlooked > 0) {
            return false;
        }
        untilOverlooked = 1 + random.nextInt(2 * OVERLOOKED);
        return true;
    }

    /** At random, or what is far from all boats first, or last. */
    private void order() {
        int draw = random.nextInt(7);
        for (int i = count - 1; draw < 4 && i > 0; i--) {
            swap(i, random.nextInt(i + 1));
        }
        double sign = draw < 6 ? 1 : -1;
        for (int i = 1; draw >= 4 && i < count; i++) {
            for (int j = i; j > 0 && sign * awayM[taken[j]] > sign * awayM[taken[j - 1]]; j--) {
                swap(j, j - 1);
            }
        }
    }

    private void swap(int i, int j) {
        int kept = taken[i];
        taken[i] = taken[j];
        taken[j] = kept;
    }

    /** The nearest other work, the nearest first. */
    private int[] nearTo(int work) {
        long[] byDistance = new long[paths.works()];
        for (int other = 0; other < byDistance.length; other++) {
            float distanceM = other == work ? Float.MAX_VALUE : (float) paths.legM(work, other);
            byDistance[other] = (long) Float.floatToIntBits(distanceM) << Integer.SIZE | other;
        }
        Arrays.sort(byDistance);
        return Arrays.stream(byDistance)
                .limit(Math.min(MOST_NEAR, paths.works() - 1))
                .mapToInt(one -> (int) one)
                .toArray();
    }

    private double awayM(int work) {
        double least = Double.POSITIVE_INFINITY;
        for (int boat = 0; boat < paths.boats(); boat++) {
            least = Math.min(least, paths.legM(paths.works() + boat, work));
        }
        return least;
    }
}
