package org.sami.crw.service.allocation;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import org.sami.crw.event.Allocation;
import org.sami.crw.service.choice.Criterion;
import org.sami.spn.value.GeoPath;
import org.sami.spn.value.GeoPoint;

/**
 * A solution of an allocation problem.
 *
 * @param problem the problem that it solves
 * @param paths the work of each boat in its order, begun work first; every boat is listed
 * @param unallocated the work without a boat
 * @param totalM sum of the lengths of all paths, along the surface, around obstacles
 * @param longestM length of the longest path
 * @param latestM the time after which the last boat is done, as metres of the fastest boat, with what boats drive in addition where they turn: {@code longestM}
 *     where all have the same speed and turn on the spot
 * @param legsMeasured number of distances computed for it
 * @param method the algorithm's name
 * @param shortfall where the algorithm reached a limit: how it handled the rest, in words
 */
public record Division(
        AllocationProblem problem,
        Map<String, List<WorkItem>> paths,
        List<Unallocated> unallocated,
        double totalM,
        double longestM,
        double latestM,
        long legsMeasured,
        String method,
        Optional<String> shortfall) {

    /** A division from the work's indices in the problem, in each boat's order. */
    static Division of(
            AllocationProblem whole,
            AllocationProblem possible,
            List<List<Integer>> shares,
            TravelCosts legs,
            String method) {
        Map<String, List<WorkItem>> paths = new LinkedHashMap<>();
        double total = 0;
        double longest = 0;
        double latest = 0;
        for (int b = 0; b < shares.size(); b++) {
            Candidate boat = whole.boats().get(b);
            List<WorkItem> path = new ArrayList<>(boat.begun());
            shares.get(b).forEach(index -> path.add(possible.work().get(index)));
            paths.put(boat.boat(), List.copyOf(path));
            double length =
                    whole.lengthM(boat, path.stream().map(WorkItem::location).toList());
            total += length;
            longest = Math.max(longest, length);
            latest = Math.max(latest, (length + legs.turnsM(b, shares.get(b))) * whole.slowness(boat));
        }
        return new Division(
                whole, paths, whole.impossible(), total, longest, latest, legs.measured(), method, legs.shortfall());
    }

    /** Orders divisions by a criterion, best first: by measured values, not by what an algorithm declares. */
    public static Comparator<Division> by(Criterion criterion) {
        return switch (criterion) {
            case COMPUTATION_TIME -> Comparator.comparingLong(Division::legsMeasured);
            case EXECUTION_TIME -> Comparator.comparingDouble(Division::latestM).thenComparing(Division::totalM);
            case EXECUTION_SAFETY ->
                Comparator.comparingInt(Division::crossings).thenComparing(Division::totalM);
            case EXECUTION_EFFICIENCY ->
                Comparator.comparingDouble(Division::totalM).thenComparing(Division::longestM);
        };
    }

    /** Number of places at which paths of two boats cross, without what they had begun. */
    public int crossings() {
        List<List<GeoPoint>> fresh = new ArrayList<>();
        for (Candidate boat : problem.boats()) {
            List<GeoPoint> path = new ArrayList<>(List.of(boat.freeAt()));
            path(boat).stream()
                    .skip(boat.begun().size())
                    .map(WorkItem::location)
                    .forEach(path::add);
            fresh.add(path);
        }
        return Crossings.of(fresh);
    }

    /** The boat of each work that somebody got, by the work's name, in the order in which each boat does it. */
    public Map<String, String> boatOf() {
        Map<String, String> boatOf = new LinkedHashMap<>();
        paths.forEach((boat, path) -> path.forEach(one -> boatOf.put(one.name(), boat)));
        return boatOf;
    }

    /** As a value for plans, with the reason for the choice of its method; paths begin with what boats had begun. */
    public Allocation toAllocation(String reason) {
        return allocation(reason, true);
    }

    /** The same without what boats had begun: they do that on other paths. */
    public Allocation toNewWork(String reason) {
        return allocation(reason, false);
    }

    private List<WorkItem> path(Candidate boat) {
        return Objects.requireNonNull(paths.get(boat.boat()), boat.boat());
    }

    private Allocation allocation(String reason, boolean withBegun) {
        Map<String, GeoPath> points = new LinkedHashMap<>();
        for (Candidate boat : problem.boats()) {
            points.put(
                    boat.boat(),
                    new GeoPath(path(boat).stream()
                            .skip(withBegun ? 0 : boat.begun().size())
                            .map(WorkItem::location)
                            .toList()));
        }
        return new Allocation(points, totalM, longestM, method)
                .withReason(reason)
                .withUnallocated(unallocated.stream().map(Unallocated::words).toList());
    }
}
