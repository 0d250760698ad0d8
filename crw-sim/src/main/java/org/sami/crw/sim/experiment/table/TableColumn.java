package org.sami.crw.sim.experiment.table;

import java.util.Objects;

/**
 * A column of an experiment's table.
 *
 * @param measure what is shown
 * @param kind the mean of one version, or the gain of one against another
 * @param of the version
 * @param against the version that it is compared with; empty text for a mean
 * @param published name of its cells in published rows; empty text where nothing was published
 */
public record TableColumn(String title, Measure measure, Kind kind, String of, String against, String published) {
    public TableColumn {
        Objects.requireNonNull(title, "title");
        Objects.requireNonNull(measure, "measure");
        Objects.requireNonNull(kind, "kind");
        Objects.requireNonNull(of, "of");
        Objects.requireNonNull(against, "against");
        Objects.requireNonNull(published, "published");
    }

    /** What a column shows of its measure. */
    public enum Kind {
        /** The mean of one version. */
        MEAN,
        /** (against - of) / the larger of both, in percent (thesis 7.1.1). */
        GAIN,
        /** (of - against) / against, in percent (thesis 8.2). */
        CHANGE;

        /** The gain of a repetition in percent; 0 where both values are 0. */
        double percent(double ofValue, double againstValue) {
            double whole = this == GAIN ? Math.max(ofValue, againstValue) : againstValue;
            double difference = this == GAIN ? againstValue - ofValue : ofValue - againstValue;
            return whole == 0 ? 0 : 100 * difference / whole;
        }
    }
}
