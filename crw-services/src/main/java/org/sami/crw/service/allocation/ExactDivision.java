package org.sami.crw.service.allocation;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;

/**
 * The best of all divisions, by dynamic programming over sets of work: the shortest path of each boat through each set (M. Held,
 * R. M. Karp, A dynamic programming approach to sequencing problems, 1962; here without return), then the best set for each
 * boat in turn. For W works and B boats O(B (2^W W² + 3^W)): for ten works and twenty boats a few million steps.
 */
final class ExactDivision {
    /** More works are not tried. */
    static final int MOST_WORK = 10;

    private final AllocationProblem problem;
    private final TravelCosts legs;
    private final Objective objective;
    private final int works;
    private final int sets;

    ExactDivision(AllocationProblem problem, TravelCosts legs, Objective objective) {
        this.problem = problem;
        this.legs = legs;
        this.objective = objective;
        works = problem.work().size();
        sets = 1 << works;
    }

    List<List<Integer>> shares() {
        int boats = problem.boats().size();
        double[] best = new double[sets];
        Arrays.fill(best, Double.POSITIVE_INFINITY);
        best[0] = 0;
        double[][] ends = new double[boats][];
        int[][] taken = new int[boats][sets];
        for (int boat = 0; boat < boats; boat++) {
            ends[boat] = shortestTo(boat);
            best = withBoat(best, lengths(boat, ends[boat]), taken[boat]);
        }
        List<List<Integer>> shares = new ArrayList<>(Collections.nCopies(boats, List.of()));
        int left = sets - 1;
        for (int boat = boats - 1; boat >= 0; boat--) {
            shares.set(boat, path(taken[boat][left], ends[boat]));
            left &= ~taken[boat][left];
        }
        return shares;
    }

    /** For each set and each last work of it: the length of the shortest path that ends there; by set times works plus last. */
    private double[] shortestTo(int boat) {
        double[] length = new double[sets * works];
        Arrays.fill(length, Double.POSITIVE_INFINITY);
        for (int last = 0; last < works; last++) {
            if (legs.canDo(boat, last)) {
                length[(1 << last) * works + last] = legs.begun(boat) + legs.first(boat, last);
            }
        }
        for (int set = 1; set < sets; set++) {
            for (int last = 0; last < works; last++) {
                double soFar = length[set * works + last];
                for (int next = 0; next < works && soFar < Double.POSITIVE_INFINITY; next++) {
                    if ((set & 1 << next) == 0 && legs.canDo(boat, next)) {
                        int at = (set | 1 << next) * works + next;
                        length[at] = Math.min(length[at], soFar + legs.between(last, next));
                    }
                }
            }
        }
        return length;
    }

    /** What the shortest path through each set costs. */
    private double[] lengths(int boat, double[] shortestTo) {
        double[] lengths = new double[sets];
        lengths[0] = legs.cost(objective.isByTime(), boat, legs.begun(boat));
        for (int set = 1; set < sets; set++) {
            lengths[set] = Double.POSITIVE_INFINITY;
            for (int last = 0; last < works; last++) {
                lengths[set] = Math.min(lengths[set], shortestTo[set * works + last]);
            }
            lengths[set] = lengths[set] < Double.POSITIVE_INFINITY
                    ? legs.cost(objective.isByTime(), boat, lengths[set])
                    : lengths[set];
        }
        return lengths;
    }

    /** The best value for each set when one boat more may take a share of it, and that share. */
    private double[] withBoat(double[] without, double[] own, int[] taken) {
        double[] best = new double[sets];
        Arrays.fill(best, Double.POSITIVE_INFINITY);
        for (int set = 0; set < sets; set++) {
            int share = set;
            while (true) {
                double value = objective.join(without[set & ~share], own[share]);
                if (value < best[set]) {
                    best[set] = value;
                    taken[set] = share;
                }
                if (share == 0) {
                    break;
                }
                share = (share - 1) & set;
            }
        }
        return best;
    }

    private List<Integer> path(int set, double[] shortestTo) {
        List<Integer> backwards = new ArrayList<>();
        int left = set;
        int next = -1;
        while (left != 0) {
            int best = -1;
            double least = Double.POSITIVE_INFINITY;
            for (int last = 0; last < works; last++) {
                double length = shortestTo[left * works + last]
                        + (next < 0 || (left & 1 << last) == 0 ? 0 : legs.between(last, next));
                if ((left & 1 << last) != 0 && (best < 0 || length < least)) {
                    best = last;
                    least = length;
                }
            }
            backwards.add(best);
            left &= ~(1 << best);
            next = best;
        }
        Collections.reverse(backwards);
        return backwards;
    }
}
