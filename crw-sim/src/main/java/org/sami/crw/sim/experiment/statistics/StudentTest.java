package org.sami.crw.sim.experiment.statistics;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.apache.commons.statistics.distribution.TDistribution;

/**
 * A two-sided t-test of the hypothesis that two means are equal.
 *
 * @param t the statistic; infinite where the samples differ and do not scatter
 * @param degreesOfFreedom of Student's distribution
 * @param p probability of a statistic at least as far from 0 if the means are equal
 */
public record StudentTest(double t, double degreesOfFreedom, double p) {
    /** The level of significance of the thesis's tables (7.1.2). */
    public static final double ALPHA = 0.05;

    /** Whether the means differ at {@link #ALPHA}. */
    public boolean isSignificant() {
        return p < ALPHA;
    }

    /** The two-sample test, of samples whose variances may differ (Welch); empty where a sample has fewer than two values. */
    public static Optional<StudentTest> twoSample(Sample first, Sample second) {
        OptionalDouble one = first.standardError();
        OptionalDouble other = second.standardError();
        if (one.isEmpty() || other.isEmpty()) {
            return Optional.empty();
        }
        double a = one.getAsDouble() * one.getAsDouble();
        double b = other.getAsDouble() * other.getAsDouble();
        double scatter = a * a / (first.size() - 1) + b * b / (second.size() - 1);
        double freedom = scatter > 0 ? (a + b) * (a + b) / scatter : first.size() + second.size() - 2.0;
        double difference = first.mean().getAsDouble() - second.mean().getAsDouble();
        return Optional.of(of(difference, Math.sqrt(a + b), freedom));
    }

    /**
     * The paired test; empty where there are fewer than two pairs.
     *
     * @throws IllegalArgumentException where the samples are not of one size
     */
    public static Optional<StudentTest> paired(Sample first, Sample second) {
        if (first.size() != second.size()) {
            throw new IllegalArgumentException("pairs of " + first.size() + " and " + second.size() + " values");
        }
        List<Double> differences = new ArrayList<>();
        for (int i = 0; i < first.size(); i++) {
            differences.add(first.values().get(i) - second.values().get(i));
        }
        Sample sample = new Sample(differences);
        OptionalDouble error = sample.standardError();
        return error.isEmpty()
                ? Optional.empty()
                : Optional.of(of(sample.mean().getAsDouble(), error.getAsDouble(), sample.size() - 1.0));
    }

    private static StudentTest of(double difference, double error, double freedom) {
        if (error == 0) {
            return difference == 0
                    ? new StudentTest(0, freedom, 1)
                    : new StudentTest(Math.copySign(Double.POSITIVE_INFINITY, difference), freedom, 0);
        }
        double t = difference / error;
        return new StudentTest(t, freedom, 2 * TDistribution.of(freedom).survivalProbability(Math.abs(t)));
    }
}
