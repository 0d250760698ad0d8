package org.sami.crw.sim.experiment;

import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.OptionalDouble;
import org.sami.crw.sim.report.Approach;
import org.sami.crw.sim.report.BoatResult;
import org.sami.crw.sim.report.Exploration;
import org.sami.crw.sim.report.LocationResult;
import org.sami.crw.sim.report.NoGoDepth;
import org.sami.crw.sim.report.RunOutcome;
import org.sami.crw.sim.report.RunReport;

/**
 * What came of one run of an experiment. Lengths are metres, measured on where boats truly were.
 *
 * @param label of its case
 * @param conditions their name
 * @param reason why it failed, in one sentence; else empty text
 * @param problems what went wrong that no plan hears of: how often
 * @param locations how many the operator gave
 * @param reported how many of them boats reported to have visited
 * @param visited how many of them boats truly visited
 * @param farthestM how near boats came to the location that they missed by most; empty where none was given or no boat came near one
 * @param areaM2 square metres that were to be explored; 0 where none were
 * @param plannedUncoveredM2 square metres of it that the tracks leave that boats were given; empty where that is not known
 * @param uncoveredM2 square metres of it that no boat came near
 * @param insideM how deep a boat came into what was to be avoided; empty where nothing was
 * @param announcedM how deep they might come at most, as the operator was told; empty where nothing was to be avoided
 * @param closestM how near two boats came to one another
 * @param underWayM the same, once both were under way
 * @param nearMillis how long every two boats that came nearer than 3 m were so near, all taken together
 * @param emptyBoats how many boats ran out of charge
 * @param runHash equal for equal runs
 */
public record ExperimentRow(
        String label,
        String conditions,
        long seed,
        RunOutcome outcome,
        String reason,
        int problems,
        long simulatedMillis,
        int locations,
        int reported,
        int visited,
        OptionalDouble farthestM,
        double areaM2,
        OptionalDouble plannedUncoveredM2,
        double uncoveredM2,
        OptionalDouble insideM,
        OptionalDouble announcedM,
        OptionalDouble closestM,
        OptionalDouble underWayM,
        long nearMillis,
        int emptyBoats,
        String runHash) {
    /** Depths are announced to a tenth of a metre. */
    private static final double TOLD_TO_M = 0.1;

    public ExperimentRow {
        Objects.requireNonNull(label, "label");
        Objects.requireNonNull(conditions, "conditions");
        Objects.requireNonNull(outcome, "outcome");
        Objects.requireNonNull(reason, "reason");
        Objects.requireNonNull(runHash, "runHash");
    }

    /** The row of a run that was reported. */
    static ExperimentRow of(String label, String conditions, RunReport report) {
        return new ExperimentRow(
                label,
                conditions,
                report.header().seed(),
                report.result().outcome(),
                report.result().reason(),
                report.problems().size(),
                report.result().simulatedMillis(),
                report.locations().size(),
                report.locationsReported(),
                report.locationsVisited(),
                report.locations().stream()
                        .flatMap(location -> location.truth().stream())
                        .map(LocationResult.Truth::nearestM)
                        .flatMapToDouble(OptionalDouble::stream)
                        .max(),
                report.map().explorations().stream()
                        .mapToDouble(Exploration::areaM2)
                        .sum(),
                planned(report),
                report.map().explorations().stream()
                        .mapToDouble(Exploration::uncoveredM2)
                        .sum(),
                NoGoDepth.of(report),
                NoGoDepth.announced(report),
                metres(report.map().closest().ever()),
                metres(report.map().closest().underWay()),
                report.map().closest().nearMillis(),
                (int) report.boats().stream().filter(ExperimentRow::ranEmpty).count(),
                report.result().runHash());
    }

    /** The row of a run that the program itself broke. */
    static ExperimentRow broken(String label, String conditions, long seed, RuntimeException fault) {
        return new ExperimentRow(
                label,
                conditions,
                seed,
                RunOutcome.FAILED,
                "the program broke: " + fault,
                0,
                0,
                0,
                0,
                0,
                OptionalDouble.empty(),
                0,
                OptionalDouble.empty(),
                0,
                OptionalDouble.empty(),
                OptionalDouble.empty(),
                OptionalDouble.empty(),
                OptionalDouble.empty(),
                0,
                0,
                "");
    }

    private static OptionalDouble planned(RunReport report) {
        List<Optional<Double>> left = report.map().explorations().stream()
                .map(exploration -> exploration.left().plannedM2())
                .toList();
        return left.isEmpty() || left.stream().anyMatch(Optional::isEmpty)
                ? OptionalDouble.empty()
                : OptionalDouble.of(
                        left.stream().mapToDouble(Optional::orElseThrow).sum());
    }

    private static OptionalDouble metres(Optional<Approach> approach) {
        return approach.map(near -> OptionalDouble.of(near.distanceM())).orElse(OptionalDouble.empty());
    }

    private static boolean ranEmpty(BoatResult boat) {
        return boat.batteryPercent() <= 0 || boat.track().stream().anyMatch(point -> point.batteryPercent() <= 0);
    }

    /** Whether a boat came deeper into what was to be avoided than the operator was told. */
    public boolean isDeeperThanAnnounced() {
        return insideM.orElse(0) > announcedM.orElse(0) + TOLD_TO_M / 2;
    }

    /** Whether the mission ended, nothing went wrong beside it, and no boat came where it was not to be expected. */
    public boolean isGreen() {
        return outcome == RunOutcome.ENDED && problems == 0 && !isDeeperThanAnnounced();
    }
}
