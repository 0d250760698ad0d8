package org.sami.crw.service.coverage;

import java.util.Arrays;
import java.util.function.DoublePredicate;
import org.locationtech.jts.geom.Coordinate;
import org.sami.crw.service.Interruption;

/**
 * Divides a tour among boats. Each piece, with the ways to it and from it, is at most as long as its boat's charge certainly lasts; within that, all
 * pieces take equally long, turns included. Where all charges together do not last for the tour, its end is left out; or, where boats recharge on the way, all exceed
 * their charges by up to the same amount.
 */
final class TourDivision {
    /** So many ways may be measured to find out which boat's piece best lies where: about a second's worth. */
    private static final int MOST_WAYS = 10_000_000;

    private static final double EXACT_M = 0.05;
    private static final double BETTER_M = 0.5;

    private final TourPlaces tour;
    private final double[] rangeM;
    private final double[] paces;
    private final double[] radiiM;
    private final boolean recharges;
    private final Ways ways;
    private int measured;

    /** Measures the way of a boat to a piece between two ends, and its way home where that counts, from whichever end is better; in metres. */
    @FunctionalInterface
    interface Ways {
        double metres(int boat, Coordinate end, Coordinate otherEnd);
    }

    /** Where the pieces lie. */
    static final class Cuts {
        private final int[] order;
        private final double[] fromM;
        private final double beyondM;
        private final double longestM;

        private Cuts(int[] order, double[] fromM, double beyondM, double longestM) {
            this.order = order;
            this.fromM = fromM;
            this.beyondM = beyondM;
            this.longestM = longestM;
        }

        /** The boat that has a piece; pieces are counted along the tour. */
        int boat(int piece) {
            return order[piece];
        }

        /** Where on the tour a piece begins; the one after the last begins where that ends. */
        double fromM(int piece) {
            return fromM[piece];
        }

        double lengthM(int piece) {
            return fromM[piece + 1] - fromM[piece];
        }

        /** Where on the tour the last piece ends. */
        double endM() {
            return fromM[fromM.length - 1];
        }

        /** By how much each way and piece may exceed its charge. */
        double beyondM() {
            return beyondM;
        }

        private boolean isBetterThan(Cuts other) {
            double differenceM = endM() - other.endM() + other.beyondM - beyondM;
            return differenceM > BETTER_M || (differenceM > -BETTER_M && longestM < other.longestM - BETTER_M);
        }
    }

    /**
     * A division to be found.
     *
     * @param rangeM how far each boat's charge is sure to last, in metres; infinite where that is not known
     * @param paces each boat's speed as a part of the fastest one's
     * @param radiiM the radius of each boat's narrowest turn, in metres; 0 for one that turns on the spot
     */
    TourDivision(TourPlaces tour, double[] rangeM, double[] paces, double[] radiiM, boolean recharges, Ways ways) {
        this.tour = tour;
        this.rangeM = rangeM.clone();
        this.paces = paces.clone();
        this.radiiM = radiiM.clone();
        this.recharges = recharges;
        this.ways = ways;
    }

    /** The best that exchanging boats two by two leads to, from an order of their pieces. */
    Cuts from(int[] first) {
        int[] order = first.clone();
        Cuts best = cuts(order);
        boolean isBetter = true;
        while (isBetter) {
            isBetter = false;
            for (int i = 0; i < order.length; i++) {
                for (int j = i + 1; j < order.length && measured < MOST_WAYS; j++) {
                    Interruption.check();
                    exchange(order, i, j);
                    Cuts other = cuts(order);
                    if (other.isBetterThan(best)) {
                        best = other;
                        isBetter = true;
                    } else {
                        exchange(order, i, j);
                    }
                }
            }
        }
        return best;
    }

    private static void exchange(int[] order, int i, int j) {
        int boat = order[i];
        order[i] = order[j];
        order[j] = boat;
    }

    /** The pieces of boats in this order: the shortest limit of time for all with which they reach the tour's end, as metres of the fastest boat. */
    private Cuts cuts(int[] order) {
        double wholeM = tour.lengthM();
        double widestM = Arrays.stream(radiiM).max().orElse(0);
        double mostM = (wholeM + widestM * tour.turns(0, wholeM))
                / Arrays.stream(paces).min().orElse(1);
        Cuts most = cuts(order, mostM, 0);
        if (most.endM() >= wholeM - EXACT_M) {
            double limitM = least(0, mostM, limit -> cuts(order, limit, 0).endM() >= wholeM - EXACT_M);
            return cuts(order, limitM, 0);
        } else if (!recharges) {
            return most;
        }
        double beyondM = least(0, wholeM, beyond -> cuts(order, mostM, beyond).endM() >= wholeM - EXACT_M);
        return cuts(order, mostM, beyondM);
    }

    /** One piece after the other, each as long as a limit and its boat's charge allow. */
    private Cuts cuts(int[] order, double limitM, double beyondM) {
        double[] fromM = new double[order.length + 1];
        double longestM = 0;
        for (int piece = 0; piece < order.length; piece++) {
            double pace = paces[order[piece]];
            double lengthM = lengthM(order[piece], fromM[piece], limitM * pace, beyondM);
            fromM[piece + 1] = fromM[piece] + lengthM;
            longestM = Math.max(longestM, withTurnsM(order[piece], fromM[piece], lengthM) / pace);
        }
        return new Cuts(order.clone(), fromM, beyondM, longestM);
    }

    /** The farther the ends of a piece lie, the longer it is with its ways. */
    private double lengthM(int boat, double fromM, double limitM, double beyondM) {
        double mostM = beforeLimitM(boat, fromM, limitM);
        double roomM = rangeM[boat] + beyondM;
        return drivenM(boat, fromM, mostM) <= roomM
                ? mostM
                : Math.max(0, least(0, mostM, length -> drivenM(boat, fromM, length) > roomM) - EXACT_M);
    }

    /** How long a piece is that a boat drives, with its turns, within a limit. */
    private double beforeLimitM(int boat, double fromM, double limitM) {
        double mostM = Math.min(limitM, tour.lengthM() - fromM);
        return radiiM[boat] == 0 || withTurnsM(boat, fromM, mostM) <= limitM
                ? mostM
                : Math.max(0, least(0, mostM, length -> withTurnsM(boat, fromM, length) > limitM) - EXACT_M);
    }

    private double withTurnsM(int boat, double fromM, double lengthM) {
        return radiiM[boat] == 0 ? lengthM : lengthM + radiiM[boat] * tour.turns(fromM, fromM + lengthM);
    }

    private double drivenM(int boat, double fromM, double lengthM) {
        measured++;
        return lengthM + ways.metres(boat, tour.at(fromM), tour.at(fromM + lengthM));
    }

    /** The least number that fulfils what greater ones fulfil too, to within 5 cm. */
    private static double least(double from, double to, DoublePredicate isFulfilled) {
        double low = from;
        double high = to;
        while (high - low > EXACT_M) {
            double middle = (low + high) / 2;
            if (isFulfilled.test(middle)) {
                high = middle;
            } else {
                low = middle;
            }
        }
        return high;
    }
}
