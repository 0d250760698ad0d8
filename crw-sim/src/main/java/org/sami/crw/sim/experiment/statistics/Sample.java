package org.sami.crw.sim.experiment.statistics;

import java.util.List;
import java.util.OptionalDouble;

/** Values that were measured, in order. */
public record Sample(List<Double> values) {
    public Sample {
        values = List.copyOf(values);
    }

    /** How many there are. */
    public int size() {
        return values.size();
    }

    /** The arithmetic mean; empty without values. */
    public OptionalDouble mean() {
        return values.stream().mapToDouble(Double::doubleValue).average();
    }

    /** The variance with n - 1 in the denominator; empty for fewer than two values. */
    public OptionalDouble variance() {
        if (size() < 2) {
            return OptionalDouble.empty();
        }
        double mean = mean().getAsDouble();
        double squares = values.stream()
                .mapToDouble(value -> (value - mean) * (value - mean))
                .sum();
        return OptionalDouble.of(squares / (size() - 1));
    }

    /** The standard error of the mean; empty for fewer than two values. */
    public OptionalDouble standardError() {
        OptionalDouble variance = variance();
        return variance.isEmpty() ? variance : OptionalDouble.of(Math.sqrt(variance.getAsDouble() / size()));
    }

    /** The value below which a part of the sample lies, interpolated between neighbours (method 7 of Hyndman and Fan, 1996); empty without values. */
    public OptionalDouble quantile(double part) {
        if (values.isEmpty()) {
            return OptionalDouble.empty();
        }
        List<Double> sorted = values.stream().sorted().toList();
        double at = part * (size() - 1);
        int below = (int) Math.floor(at);
        int above = Math.min(below + 1, size() - 1);
        return OptionalDouble.of(sorted.get(below) + (at - below) * (sorted.get(above) - sorted.get(below)));
    }
}
