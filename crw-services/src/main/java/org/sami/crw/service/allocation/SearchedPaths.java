package org.sami.crw.service.allocation;

import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;

/**
 * The paths of all boats during a search that removes work and inserts it again, with their weight: the cost of each path raised to a power of two.
 * Changes since a checkpoint can be undone.
 */
final class SearchedPaths {
    private static final int NOBODY = -1;

    private final TravelCosts legs;
    private final boolean byTime;
    /** From work, and from where the boats are free (their index after the last work's), to work. */
    private final double[][] legM;

    private final boolean[][] canDo;
    private final int workCount;
    private final int[][] stops;
    private final int[] size;
    private final int[] boatOf;
    private final int[] indexOf;
    private final double[] lengthM;
    private final double[] weight;
    private final double unitM;
    private int doublings;

    private final int[][] keptStops;
    private final int[] keptSize;
    private final boolean[] changed;

    SearchedPaths(AllocationProblem problem, TravelCosts legs, boolean byTime, List<List<Integer>> shares) {
        this.legs = legs;
        this.byTime = byTime;
        legM = legs.matrix();
        workCount = problem.work().size();
        int boats = shares.size();
        canDo = new boolean[boats][workCount];
        stops = new int[boats][workCount];
        keptStops = new int[boats][workCount];
        size = new int[boats];
        keptSize = new int[boats];
        changed = new boolean[boats];
        lengthM = new double[boats];
        weight = new double[boats];
        boatOf = new int[workCount];
        indexOf = new int[workCount];
        for (int boat = 0; boat < boats; boat++) {
            for (int work = 0; work < workCount; work++) {
                canDo[boat][work] = legs.canDo(boat, work);
            }
            for (int work : shares.get(boat)) {
                stops[boat][size[boat]++] = work;
            }
            measure(boat);
        }
        unitM = Math.max(1, greatestCostM());
        weighByPower(0);
    }

    /** From now on the weight of a path is its cost, squared so many times. */
    void weighByPower(int exponentOfTwo) {
        doublings = exponentOfTwo;
        for (int boat = 0; boat < weight.length; boat++) {
            weight[boat] = weightOf(boat, lengthM[boat]);
        }
    }

    private double weightOf(int boat, double length) {
        double power = legs.cost(byTime, boat, length) / unitM;
        for (int i = 0; i < doublings; i++) {
            power *= power;
        }
        return power;
    }

    /** Sum of the weights of all paths. */
    double totalWeight() {
        double sum = 0;
        for (double one : weight) {
            sum += one;
        }
        return sum;
    }

    /** The greatest cost of a path. */
    double greatestCostM() {
        double longest = 0;
        for (int boat = 0; boat < lengthM.length; boat++) {
            longest = Math.max(longest, legs.cost(byTime, boat, lengthM[boat]));
        }
        return longest;
    }

    /** The cost of all paths. */
    double totalCostM() {
        double total = 0;
        for (int boat = 0; boat < lengthM.length; boat++) {
            total += legs.cost(byTime, boat, lengthM[boat]);
        }
        return total;
    }

    /** The boat whose path weighs most. */
    int heaviest() {
        int heaviest = 0;
        for (int boat = 1; boat < weight.length; boat++) {
            heaviest = weight[boat] > weight[heaviest] ? boat : heaviest;
        }
        return heaviest;
    }

    int workCount() {
        return workCount;
    }

    int boatCount() {
        return size.length;
    }

    int size(int boat) {
        return size[boat];
    }

    int stop(int boat, int index) {
        return stops[boat][index];
    }

    /** The boat on whose path some work is; below zero where it was removed. */
    int boatOf(int work) {
        return boatOf[work];
    }

    int indexOf(int work) {
        return indexOf[work];
    }

    double legM(int from, int to) {
        return legM[from][to];
    }

    boolean isChanged(int boat) {
        return changed[boat];
    }

    /** Makes the paths as they are now those to which {@link #rollBack} leads. */
    void checkpoint() {
        Arrays.fill(changed, false);
    }

    /** Takes back all changes since the checkpoint. */
    void rollBack() {
        for (int boat = 0; boat < changed.length; boat++) {
            if (changed[boat]) {
                size[boat] = keptSize[boat];
                System.arraycopy(keptStops[boat], 0, stops[boat], 0, size[boat]);
                measure(boat);
            }
        }
    }

    private void keepForRollBack(int boat) {
        if (!changed[boat]) {
            changed[boat] = true;
            keptSize[boat] = size[boat];
            System.arraycopy(stops[boat], 0, keptStops[boat], 0, size[boat]);
        }
    }

    /**
     * Removes successive stops of a path.
     *
     * @param from index of the first stop to remove
     * @param until index after the last
     * @param keptFrom index of the first stop among them to keep
     * @param kept number of stops to keep from there on; may be 0
     * @param into receives the removed work
     * @param count number of entries already in it
     * @return number of entries in it afterwards
     */
    int remove(int boat, int from, int until, int keptFrom, int kept, int[] into, int count) {
        keepForRollBack(boat);
        int out = count;
        int[] path = stops[boat];
        int left = from;
        for (int i = from; i < size[boat]; i++) {
            if (i < until && (i < keptFrom || i >= keptFrom + kept)) {
                boatOf[path[i]] = NOBODY;
                into[out++] = path[i];
            } else {
                path[left++] = path[i];
            }
        }
        size[boat] = left;
        measure(boat);
        return out;
    }

    void insert(int boat, int before, int work) {
        keepForRollBack(boat);
        int[] path = stops[boat];
        System.arraycopy(path, before, path, before + 1, size[boat] - before);
        path[before] = work;
        size[boat]++;
        measure(boat);
    }

    private void measure(int boat) {
        double length = legs.begun(boat);
        int from = workCount + boat;
        for (int i = 0; i < size[boat]; i++) {
            int work = stops[boat][i];
            boatOf[work] = boat;
            indexOf[work] = i;
            length += legM[from][work];
            from = work;
        }
        lengthM[boat] = length;
        weight[boat] = weightOf(boat, length);
    }

    boolean canDo(int boat, int work) {
        return canDo[boat][work];
    }

    /** How much longer a path gets with some work before a stop. */
    double addedM(int boat, int before, int work) {
        int[] path = stops[boat];
        double[] previous = legM[before == 0 ? workCount + boat : path[before - 1]];
        return before == size[boat]
                ? previous[work]
                : previous[work] + legM[work][path[before]] - previous[path[before]];
    }

    /** How much more a path weighs when it is so much longer. */
    double addedWeight(int boat, double addedM) {
        return weightOf(boat, lengthM[boat] + addedM) - weight[boat];
    }

    List<List<Integer>> shares() {
        return IntStream.range(0, stops.length)
                .mapToObj(boat ->
                        Arrays.stream(stops[boat], 0, size[boat]).boxed().toList())
                .toList();
    }
}
