package org.sami.crw.sim.experiment;

import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.OptionalDouble;
import org.sami.crw.report.Approach;
import org.sami.crw.report.BoatResult;
import org.sami.crw.report.Exploration;
import org.sami.crw.report.LocationResult;
import org.sami.crw.report.NoGoDepth;
import org.sami.crw.report.RunOutcome;
import org.sami.crw.report.RunReport;
import org.sami.crw.report.TargetSummary;

/**
 * What came of one run of an experiment. Lengths are metres, areas square metres, measured on where boats truly were.
 *
 * @param run which run it was
 * @param ending how it ended
 * @param visits the locations that the operator gave
 * @param coverage the areas that boats were to explore
 * @param distances how near boats came to one another and to what was to be avoided
 * @param emptyBoats how many boats ran out of charge
 * @param targets how many targets the detectors of robots reported
 */
public record ExperimentRow(
        Run run, Ending ending, Visits visits, Coverage coverage, Distances distances, int emptyBoats, int targets) {
    public ExperimentRow {
        Objects.requireNonNull(run, "run");
        Objects.requireNonNull(ending, "ending");
        Objects.requireNonNull(visits, "visits");
        Objects.requireNonNull(coverage, "coverage");
        Objects.requireNonNull(distances, "distances");
    }

    /**
     * Which run of the experiment it was.
     *
     * @param label of its case
     * @param conditions their name
     */
    public record Run(String label, String conditions, long seed) {
        public Run {
            Objects.requireNonNull(label, "label");
            Objects.requireNonNull(conditions, "conditions");
        }
    }

    /**
     * How a run ended.
     *
     * @param reason why it failed, in one sentence; else empty text
     * @param problems how many problems occurred that no plan hears of
     * @param hash equal for equal runs; empty text where the program broke
     */
    public record Ending(RunOutcome outcome, String reason, int problems, long simulatedMillis, String hash) {
        public Ending {
            Objects.requireNonNull(outcome, "outcome");
            Objects.requireNonNull(reason, "reason");
            Objects.requireNonNull(hash, "hash");
        }

        static Ending of(RunReport report) {
            return new Ending(
                    report.result().outcome(),
                    report.result().reason(),
                    report.problems().size(),
                    report.result().simulatedMillis(),
                    report.result().runHash());
        }
    }

    /**
     * The locations that the operator gave.
     *
     * @param reported how many of them boats reported to have visited
     * @param visited how many of them boats truly visited
     * @param farthestM how near boats came to the location that they missed by most; empty where none was given or no boat came near one
     */
    public record Visits(int locations, int reported, int visited, OptionalDouble farthestM) {
        static final Visits NONE = new Visits(0, 0, 0, OptionalDouble.empty());

        static Visits of(RunReport report) {
            return new Visits(
                    report.locations().size(),
                    report.locationsReported(),
                    report.locationsVisited(),
                    report.locations().stream()
                            .flatMap(location -> location.truth().stream())
                            .map(LocationResult.Truth::nearestM)
                            .flatMapToDouble(OptionalDouble::stream)
                            .max());
        }
    }

    /**
     * The areas that boats were to explore.
     *
     * @param areaM2 of all of them; 0 where there were none
     * @param plannedUncoveredM2 what of it the tracks leave that boats were given; empty where that is not known
     * @param uncoveredM2 what of it no boat came near
     */
    public record Coverage(double areaM2, OptionalDouble plannedUncoveredM2, double uncoveredM2) {
        static final Coverage NONE = new Coverage(0, OptionalDouble.empty(), 0);

        static Coverage of(RunReport report) {
            List<Exploration> explorations = report.map().explorations();
            return new Coverage(
                    explorations.stream().mapToDouble(Exploration::areaM2).sum(),
                    planned(explorations),
                    explorations.stream().mapToDouble(Exploration::uncoveredM2).sum());
        }

        private static OptionalDouble planned(List<Exploration> explorations) {
            List<Optional<Double>> left = explorations.stream()
                    .map(exploration -> exploration.left().plannedM2())
                    .toList();
            return left.isEmpty() || left.stream().anyMatch(Optional::isEmpty)
                    ? OptionalDouble.empty()
                    : OptionalDouble.of(
                            left.stream().mapToDouble(Optional::orElseThrow).sum());
        }
    }

    /**
     * How near boats came to one another, and to what was to be avoided.
     *
     * @param insideM how deep a boat came into what was to be avoided; empty where nothing was
     * @param announcedM how deep they might come at most, as announced to the operator; empty where nothing was to be avoided
     * @param closestM how near two boats came to one another
     * @param underWayM the same, once both were under way
     * @param nearMillis how long two boats were nearer than 3 m to one another, summed over all pairs
     */
    public record Distances(
            OptionalDouble insideM,
            OptionalDouble announcedM,
            OptionalDouble closestM,
            OptionalDouble underWayM,
            long nearMillis) {
        /** Depths are announced to a tenth of a metre. */
        private static final double ANNOUNCED_RESOLUTION_M = 0.1;

        static final Distances NONE = new Distances(
                OptionalDouble.empty(), OptionalDouble.empty(), OptionalDouble.empty(), OptionalDouble.empty(), 0);

        static Distances of(RunReport report) {
            return new Distances(
                    NoGoDepth.of(report),
                    NoGoDepth.announced(report),
                    metres(report.map().closest().ever()),
                    metres(report.map().closest().underWay()),
                    report.map().closest().nearMillis());
        }

        /** Whether a boat came deeper into avoided areas than announced to the operator. */
        public boolean areDeeperThanAnnounced() {
            return insideM.orElse(0) > announcedM.orElse(0) + ANNOUNCED_RESOLUTION_M / 2;
        }

        private static OptionalDouble metres(Optional<Approach> approach) {
            return approach.map(near -> OptionalDouble.of(near.distanceM())).orElse(OptionalDouble.empty());
        }
    }

    /** The row of a run that was reported. */
    static ExperimentRow of(String label, String conditions, RunReport report) {
        return new ExperimentRow(
                new Run(label, conditions, report.header().seed()),
                Ending.of(report),
                Visits.of(report),
                Coverage.of(report),
                Distances.of(report),
                (int) report.boats().stream().filter(ExperimentRow::ranEmpty).count(),
                TargetSummary.of(report.readings()).size());
    }

    /** The row of a run that the program itself broke. */
    static ExperimentRow broken(String label, String conditions, long seed, RuntimeException fault) {
        return failed(new Run(label, conditions, seed), "the program broke: " + fault);
    }

    /** The row of a run of which nothing is known but why it failed. */
    static ExperimentRow failed(Run run, String reason) {
        return new ExperimentRow(
                run, new Ending(RunOutcome.FAILED, reason, 0, 0, ""), Visits.NONE, Coverage.NONE, Distances.NONE, 0, 0);
    }

    private static boolean ranEmpty(BoatResult boat) {
        return boat.batteryPercent() <= 0 || boat.track().stream().anyMatch(point -> point.batteryPercent() <= 0);
    }

    /** Whether the mission ended without problems, and no boat came deeper into avoided areas than announced. */
    public boolean isGreen() {
        return ending.outcome() == RunOutcome.ENDED && ending.problems() == 0 && !distances.areDeeperThanAnnounced();
    }
}
