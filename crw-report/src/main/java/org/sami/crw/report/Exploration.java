package org.sami.crw.report;

import java.util.List;
import java.util.Objects;
import java.util.Optional;

/**
 * What became of an area that boats were to explore. A point of it is covered where a track comes as near as half the spacing.
 *
 * @param askedAtMillis time of the run at which it was asked
 * @param spacingM distance between two lanes in metres
 * @param areaM2 square metres to be explored: the area without what was to be avoided
 * @param left what tracks leave of it
 * @param uncovered where that is, by the best tracks that are known, without crumbs of less than a square metre
 */
public record Exploration(long askedAtMillis, double spacingM, double areaM2, Left left, List<MapArea> uncovered) {
    /**
     * Square metres that are left by the planned, the reported and the true tracks;
     * empty where that is not known.
     */
    public record Left(Optional<Double> plannedM2, Optional<Double> reportedM2, Optional<Double> trueM2) {
        public Left {
            Objects.requireNonNull(plannedM2, "plannedM2");
            Objects.requireNonNull(reportedM2, "reportedM2");
            Objects.requireNonNull(trueM2, "trueM2");
        }
    }

    public Exploration {
        Objects.requireNonNull(left, "left");
        uncovered = List.copyOf(uncovered);
    }

    /** Square metres that no boat came near, by the best tracks that are known: the true ones, else the reported ones. */
    public double uncoveredM2() {
        return left.trueM2().or(left::reportedM2).orElse(areaM2);
    }

    /** The part in percent that is covered where so many square metres are left. */
    public double percent(double leftM2) {
        return 100 * (1 - leftM2 / Math.max(1e-9, areaM2));
    }
}
