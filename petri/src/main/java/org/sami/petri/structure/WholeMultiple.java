package org.sami.petri.structure;

import java.util.Optional;
import java.util.function.Predicate;

/**
 * Whole numbers in the same proportions as the floating-point numbers of a solver: those of the smallest scale for which a check holds. Corners of linear programs with
 * whole data are fractions with one small common denominator, so a small scale is found where the solver was near such a corner.
 */
final class WholeMultiple {
    private static final int MOST = 5_000;
    private static final double NOISE = 1e-7;

    private WholeMultiple() {}

    /** Numbers of 0 or more that pass the check exactly; empty where no scale up to a limit gives such. */
    static Optional<IntegerVector> of(double[] values, Predicate<IntegerVector> check) {
        double least = Double.MAX_VALUE;
        for (double value : values) {
            least = value > NOISE ? Math.min(least, value) : least;
        }
        if (least == Double.MAX_VALUE) {
            return Optional.empty();
        }
        for (double unit : new double[] {1, least}) {
            for (int scale = 1; scale <= MOST; scale++) {
                double factor = scale / unit;
                if (nearWhole(values, factor)) {
                    IntegerVector whole = rounded(values, factor);
                    if (passes(whole, check)) {
                        return Optional.of(whole.dividedBy(Math.max(1, whole.greatestDivisor())));
                    }
                }
            }
        }
        return Optional.empty();
    }

    private static boolean nearWhole(double[] values, double factor) {
        for (double value : values) {
            double scaled = value * factor;
            if (scaled > 1e12 || Math.abs(scaled - Math.rint(scaled)) > NOISE * (1 + factor)) {
                return false;
            }
        }
        return true;
    }

    private static IntegerVector rounded(double[] values, double factor) {
        long[] whole = new long[values.length];
        for (int i = 0; i < values.length; i++) {
            whole[i] = Math.max(0, Math.round(values[i] * factor));
        }
        return IntegerVector.of(whole);
    }

    private static boolean passes(IntegerVector whole, Predicate<IntegerVector> check) {
        try {
            return check.test(whole);
        } catch (ArithmeticException e) {
            return false; // too large to be checked
        }
    }
}
