package org.sami.crw.service.allocation;

/** What a division of work is the best by, as far as changes of one or two paths show it. Lengths in metres. */
enum Objective {
    /** The least sum of all paths. */
    TOTAL {
        @Override
        boolean better(double oldA, double oldB, double newA, double newB) {
            return newA + newB < oldA + oldB - LEAST_GAIN_M;
        }

        @Override
        double join(double length, double other) {
            return length + other;
        }

        @Override
        double value(SearchedPaths paths) {
            return paths.totalCostM();
        }

        @Override
        int doublings(double part) {
            return 0;
        }

        @Override
        double temperature(double part) {
            return falling(0.02, 0.0005, part);
        }
    },
    /** The shortest longest path; of equally long ones the least sum. */
    LONGEST {
        @Override
        boolean better(double oldA, double oldB, double newA, double newB) {
            double oldLongest = Math.max(oldA, oldB);
            double newLongest = Math.max(newA, newB);
            return newLongest < oldLongest - LEAST_GAIN_M
                    || (newLongest <= oldLongest && newA + newB < oldA + oldB - LEAST_GAIN_M);
        }

        @Override
        double join(double length, double other) {
            return Math.max(length, other);
        }

        @Override
        double value(SearchedPaths paths) {
            return paths.greatestCostM();
        }

        @Override
        int doublings(double part) {
            return (int) Math.round(3 + 2 * part);
        }

        @Override
        double temperature(double part) {
            return falling(0.05, 0.001, part);
        }
    };

    /** Less is no gain: rounding must not make a search go round in circles. */
    private static final double LEAST_GAIN_M = 1e-6;

    /** Whether paths count by the time that their boats take for them: where the longest path counts. */
    boolean isByTime() {
        return this == LONGEST;
    }

    /** Whether two paths are better at their new lengths than at their old ones, all others being as they are. */
    abstract boolean better(double oldA, double oldB, double newA, double newB);

    /** The objective over the paths of some boats and of one more. */
    abstract double join(double length, double other);

    /** The objective over all paths of a search; less is better. */
    abstract double value(SearchedPaths paths);

    /** How often a search squares a path's cost to weigh it, when such a part of the search is done, from 0 to 1. */
    abstract int doublings(double part);

    /** How much worse a search accepts then, relative to the norm. */
    abstract double temperature(double part);

    private static double falling(double first, double last, double part) {
        return first * StrictMath.pow(last / first, part);
    }
}
