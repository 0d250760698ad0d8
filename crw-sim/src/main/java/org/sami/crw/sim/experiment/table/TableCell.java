package org.sami.crw.sim.experiment.table;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.stream.Collectors;
import org.sami.crw.sim.experiment.statistics.Sample;
import org.sami.crw.sim.experiment.statistics.StudentTest;

/**
 * What an experiment found for one configuration and one column.
 *
 * @param values of the repetitions that count: gains in percent, or the measure itself
 * @param twoSample whether the versions' means differ, of independent samples; empty for a mean, and for fewer than two repetitions
 * @param paired the same of pairs
 */
public record TableCell(
        TableColumn column, Sample values, Optional<StudentTest> twoSample, Optional<StudentTest> paired) {
    public TableCell {
        Objects.requireNonNull(column, "column");
        Objects.requireNonNull(values, "values");
        Objects.requireNonNull(twoSample, "twoSample");
        Objects.requireNonNull(paired, "paired");
    }

    /**
     * The cell of a column.
     *
     * @param repetitions whole ones, each with its rows by version
     */
    static TableCell of(TableColumn column, List<Map<String, RunRow>> repetitions) {
        if (column.kind() == TableColumn.Kind.MEAN) {
            List<Double> values = repetitions.stream()
                    .map(rows -> value(column, rows, column.of()))
                    .filter(OptionalDouble::isPresent)
                    .map(OptionalDouble::getAsDouble)
                    .collect(Collectors.toList());
            return new TableCell(column, new Sample(values), Optional.empty(), Optional.empty());
        }
        List<Double> of = new ArrayList<>();
        List<Double> against = new ArrayList<>();
        List<Double> gains = new ArrayList<>();
        for (Map<String, RunRow> rows : repetitions) {
            OptionalDouble one = value(column, rows, column.of());
            OptionalDouble other = value(column, rows, column.against());
            if (one.isPresent() && other.isPresent()) {
                of.add(one.getAsDouble());
                against.add(other.getAsDouble());
                gains.add(column.kind().percent(one.getAsDouble(), other.getAsDouble()));
            }
        }
        Sample first = new Sample(of);
        Sample second = new Sample(against);
        return new TableCell(
                column, new Sample(gains), StudentTest.twoSample(first, second), StudentTest.paired(first, second));
    }

    private static OptionalDouble value(TableColumn column, Map<String, RunRow> rows, String version) {
        return column.measure().of(Objects.requireNonNull(rows.get(version), version));
    }

    /** Its text: mean and standard error, in brackets where the two-sample test finds no difference, with a star where only the paired one does. */
    public String text() {
        if (values.size() == 0) {
            return "-";
        }
        boolean isGain = column.kind() != TableColumn.Kind.MEAN;
        String unit = isGain ? " %" : "";
        String error = values.standardError().isEmpty()
                ? ""
                : " [± " + number(values.standardError().getAsDouble()) + "]";
        String text = number(values.mean().getAsDouble()) + unit + error;
        if (!isGain || twoSample.map(StudentTest::isSignificant).orElse(false)) {
            return text;
        }
        return "(" + text + ")" + (paired.map(StudentTest::isSignificant).orElse(false) ? "*" : "");
    }

    private static String number(double value) {
        String text = String.format(Locale.ROOT, Math.abs(value) < 9.95 ? "%.1f" : "%.0f", value);
        return text.equals("-0.0") ? "0.0" : text;
    }
}
