package org.sami.crw.service.allocation;

import java.util.Arrays;
import java.util.List;

/**
 * A path of a boat through locations, from where the boat is free, built by going to the nearest remaining location (thesis 7.0.3, footnote); among
 * equally near ones, to the one with the lowest index. Locations are added in order of index.
 *
 * <p>The length of a path has in it what a boat with a turning circle drives in addition where it turns. Which location is nearest does not depend on that.
 *
 * <p>Adding a location changes nothing before the first stop from which it is nearer than the next one, so only the rest is rebuilt. Lengths are
 * summed from the start, so that they equal those of a path built at once, bit for bit.
 */
final class NearestNeighbourPath {
    private final TravelCosts legs;
    private final int boat;
    /** The locations in the order of visits. */
    private int[] order = new int[8];
    /** Length of the path up to and including each of them. */
    private double[] lengthTo = new double[8];

    private int size;

    private int[] candidateOrder = new int[8];
    private double[] candidateLengthTo = new double[8];

    NearestNeighbourPath(TravelCosts legs, int boat) {
        this.legs = legs;
        this.boat = boat;
    }

    /** Length of the path with one location more, or infinity where it is not below a limit. */
    double lengthWith(int location, double limit) {
        double length = build(location, limit);
        return length < limit ? length : Double.POSITIVE_INFINITY;
    }

    /** Adds a location; its index is higher than those that are there. */
    void add(int location) {
        build(location, Double.POSITIVE_INFINITY);
        int[] oldOrder = order;
        double[] oldLengthTo = lengthTo;
        order = candidateOrder;
        lengthTo = candidateLengthTo;
        candidateOrder = oldOrder;
        candidateLengthTo = oldLengthTo;
        size++;
    }

    List<Integer> locations() {
        return Arrays.stream(order, 0, size).boxed().toList();
    }

    /** Builds the candidate; gives up as soon as its length reaches the limit. Returns the length so far. */
    private double build(int location, double limit) {
        reserve(size + 1);
        int at = firstChange(location);
        System.arraycopy(order, 0, candidateOrder, 0, at);
        System.arraycopy(lengthTo, 0, candidateLengthTo, 0, at);
        candidateOrder[at] = location;
        System.arraycopy(order, at, candidateOrder, at + 1, size - at);
        double length = (at == 0 ? legs.begun(boat) : lengthTo[at - 1])
                + distanceFrom(order, at, location)
                + turnBefore(candidateOrder, at);
        candidateLengthTo[at] = length;
        for (int i = at + 1; i <= size && length < limit; i++) {
            int nearest = nearestFrom(i);
            length += distanceFrom(candidateOrder, i, candidateOrder[nearest]);
            swap(i, nearest);
            length += turnBefore(candidateOrder, i);
            candidateLengthTo[i] = length;
        }
        return length;
    }

    private int firstChange(int location) {
        for (int i = 0; i < size; i++) {
            if (distanceFrom(order, i, location) < distanceFrom(order, i, order[i])) {
                return i;
            }
        }
        return size;
    }

    /** Where in the candidate's rest the location stands that is nearest to the stop before it. */
    private int nearestFrom(int from) {
        int best = from;
        double bestDistance = distanceFrom(candidateOrder, from, candidateOrder[from]);
        for (int i = from + 1; i <= size; i++) {
            double distance = distanceFrom(candidateOrder, from, candidateOrder[i]);
            if (distance < bestDistance || (distance == bestDistance && candidateOrder[i] < candidateOrder[best])) {
                best = i;
                bestDistance = distance;
            }
        }
        return best;
    }

    /** Distance to a location from the stop before a position in an order, or from the start. */
    private double distanceFrom(int[] stops, int position, int location) {
        return legs.leg(boat, position == 0 ? -1 : stops[position - 1], location);
    }

    /** What the boat drives in addition at the stop before a position, where it turns to the stop there. */
    private double turnBefore(int[] stops, int position) {
        return position == 0
                ? 0
                : legs.turn(boat, position == 1 ? -1 : stops[position - 2], stops[position - 1], stops[position]);
    }

    private void swap(int i, int j) {
        int kept = candidateOrder[i];
        candidateOrder[i] = candidateOrder[j];
        candidateOrder[j] = kept;
    }

    private void reserve(int needed) {
        if (candidateOrder.length < needed) {
            candidateOrder = Arrays.copyOf(candidateOrder, needed * 2);
            candidateLengthTo = Arrays.copyOf(candidateLengthTo, needed * 2);
        }
    }
}
