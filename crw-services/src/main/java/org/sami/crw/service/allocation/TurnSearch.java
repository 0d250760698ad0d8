package org.sami.crw.service.allocation;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;

/**
 * Improves a division for boats with turning circles, which the other searches do not know: work moves to another place on the same or another path, parts of a
 * path are reversed, and two boats exchange the rests of their paths, where the boats are done sooner with their turns counted. Takes the first change that helps, in a fixed order, until none does or a number
 * of distances is measured; equal problems have equal answers.
 */
final class TurnSearch {
    /** Some quarter of a second's worth. */
    private static final long BUDGET = 5_000_000;

    private final TravelCosts legs;
    private final Objective objective;
    private final long until;
    private final List<List<Integer>> paths = new ArrayList<>();
    private final double[] cost;

    private TurnSearch(TravelCosts legs, Objective objective, List<List<Integer>> shares) {
        this.legs = legs;
        this.objective = objective;
        until = legs.measured() + BUDGET;
        shares.forEach(share -> paths.add(new ArrayList<>(share)));
        cost = new double[shares.size()];
        for (int boat = 0; boat < cost.length; boat++) {
            cost[boat] = costOf(boat, paths.get(boat));
        }
    }

    /** The best to which any of some divisions leads: never worse than each of them. */
    static List<List<Integer>> best(TravelCosts legs, Objective objective, List<List<List<Integer>>> divisions) {
        TurnSearch best = new TurnSearch(legs, objective, divisions.get(0));
        best.run();
        for (List<List<Integer>> other : divisions.subList(1, divisions.size())) {
            TurnSearch search = new TurnSearch(legs, objective, other);
            search.run();
            best = search.value() < best.value() ? search : best;
        }
        return best.paths;
    }

    private double value() {
        double value = cost[0];
        for (int boat = 1; boat < cost.length; boat++) {
            value = objective.join(value, cost[boat]);
        }
        return value;
    }

    private void run() {
        boolean better = true;
        while (better && legs.measured() < until) {
            better = false;
            for (int from = 0; from < cost.length; from++) {
                better |= reverse(from);
                for (int to = 0; to < cost.length; to++) {
                    better |= move(from, to);
                }
            }
            for (int from = 0; from < cost.length && !better; from++) {
                for (int to = from + 1; to < cost.length; to++) {
                    better |= exchangeRests(from, to);
                }
            }
        }
    }

    private boolean reverse(int boat) {
        boolean any = false;
        List<Integer> path = paths.get(boat);
        for (int from = 0; from < path.size(); from++) {
            for (int to = from + 1; to < path.size() && legs.measured() < until; to++) {
                List<Integer> part = path.subList(from, to + 1);
                Collections.reverse(part);
                double now = costOf(boat, path);
                if (objective.better(cost[boat], 0, now, 0)) {
                    cost[boat] = now;
                    any = true;
                } else {
                    Collections.reverse(part);
                }
            }
        }
        return any;
    }

    private boolean move(int from, int to) {
        boolean any = false;
        List<Integer> source = paths.get(from);
        for (int at = 0; at < source.size() && legs.measured() < until; at++) {
            if (legs.canDo(to, source.get(at))) {
                any |= move(from, at, to);
            }
        }
        return any;
    }

    private boolean move(int from, int at, int to) {
        List<Integer> source = paths.get(from);
        List<Integer> target = paths.get(to);
        int work = source.remove(at);
        double without = costOf(from, source);
        for (int before = 0; before <= target.size(); before++) {
            if (from == to && before == at) {
                continue;
            }
            target.add(before, work);
            double with = costOf(to, target);
            boolean better = from == to
                    ? objective.better(cost[from], 0, with, 0)
                    : objective.better(cost[from], cost[to], without, with);
            if (better) {
                cost[from] = without;
                cost[to] = with;
                return true;
            }
            target.remove(before);
        }
        source.add(at, work);
        return false;
    }

    /** Two boats go on, each from some stop, with what the other would have done. */
    private boolean exchangeRests(int a, int b) {
        List<Integer> one = paths.get(a);
        List<Integer> other = paths.get(b);
        for (int i = 0; i <= one.size(); i++) {
            for (int j = 0; j <= other.size() && legs.measured() < until; j++) {
                List<Integer> newOne = joined(one.subList(0, i), other.subList(j, other.size()));
                List<Integer> newOther = joined(other.subList(0, j), one.subList(i, one.size()));
                double costOfOne = costOf(a, newOne);
                double costOfOther = costOf(b, newOther);
                if (objective.better(cost[a], cost[b], costOfOne, costOfOther)
                        && canDo(a, newOne)
                        && canDo(b, newOther)) {
                    paths.set(a, newOne);
                    paths.set(b, newOther);
                    cost[a] = costOfOne;
                    cost[b] = costOfOther;
                    return true;
                }
            }
        }
        return false;
    }

    private static List<Integer> joined(List<Integer> first, List<Integer> rest) {
        List<Integer> joined = new ArrayList<>(first);
        joined.addAll(rest);
        return joined;
    }

    private boolean canDo(int boat, List<Integer> path) {
        return path.stream().allMatch(work -> legs.canDo(boat, work));
    }

    /** Turns take time, but no charge. */
    private double costOf(int boat, List<Integer> path) {
        double cost = legs.cost(objective.isByTime(), boat, legs.lengthM(boat, path));
        return objective.isByTime() ? cost + legs.timeM(boat, legs.turnsM(boat, path)) : cost;
    }
}
