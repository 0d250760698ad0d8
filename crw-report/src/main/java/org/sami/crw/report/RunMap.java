package org.sami.crw.report;

import java.util.List;
import java.util.Objects;
import java.util.OptionalDouble;

/**
 * What the map of a run has in addition to tracks and locations.
 *
 * @param areas of the plan, each once, in the order in which the plan came to them
 * @param spots of the plan, likewise
 * @param explorations likewise
 * @param closest how near boats came to one another
 * @param paths that boats were given, in order of time
 * @param announcedM how deep boats might come into avoided areas at most, as announced to the operator before they drove, in metres; empty where nothing was announced
 */
public record RunMap(
        List<MapArea> areas,
        List<MapSpot> spots,
        List<Exploration> explorations,
        ClosestApproach closest,
        List<MapPath> paths,
        OptionalDouble announcedM) {
    public RunMap {
        Objects.requireNonNull(announcedM, "announcedM");
        paths = List.copyOf(paths);
        areas = List.copyOf(areas);
        spots = List.copyOf(spots);
        explorations = List.copyOf(explorations);
        Objects.requireNonNull(closest, "closest");
    }

    /** A map without paths, of a run in which no depths were announced. */
    public RunMap(List<MapArea> areas, List<MapSpot> spots, List<Exploration> explorations, ClosestApproach closest) {
        this(areas, spots, explorations, closest, List.of(), OptionalDouble.empty());
    }

    /** The same, of a run in which the depth into avoided areas was announced to the operator; empty where nothing was announced. */
    public RunMap announcing(OptionalDouble depthM) {
        return new RunMap(areas, spots, explorations, closest, paths, depthM);
    }

    /** The map of a plan that names neither areas nor points. */
    public static RunMap of(List<BoatResult> boats) {
        return new RunMap(List.of(), List.of(), List.of(), ClosestApproach.of(boats));
    }
}
