package org.sami.crw.sim.report;

import java.util.List;
import java.util.Objects;

/**
 * What the map of a run has beside tracks and locations.
 *
 * @param areas of the plan, each once, in the order in which the plan came to them
 * @param spots of the plan, likewise
 * @param explorations likewise
 * @param closest how near boats came to one another
 * @param paths that boats were given, in order of time
 */
public record RunMap(
        List<MapArea> areas,
        List<MapSpot> spots,
        List<Exploration> explorations,
        ClosestApproach closest,
        List<MapPath> paths) {
    public RunMap {
        paths = List.copyOf(paths);
        areas = List.copyOf(areas);
        spots = List.copyOf(spots);
        explorations = List.copyOf(explorations);
        Objects.requireNonNull(closest, "closest");
    }

    /** A map without paths. */
    public RunMap(List<MapArea> areas, List<MapSpot> spots, List<Exploration> explorations, ClosestApproach closest) {
        this(areas, spots, explorations, closest, List.of());
    }

    /** The map of a plan that names neither areas nor points. */
    public static RunMap of(List<BoatResult> boats) {
        return new RunMap(List.of(), List.of(), List.of(), ClosestApproach.of(boats));
    }
}
