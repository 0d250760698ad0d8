package org.sami.crw.service.allocation;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import org.sami.crw.service.Geodesy;
import org.sami.crw.service.path.WayLengths;
import org.sami.crw.service.water.Water;
import org.sami.spn.value.GeoPoint;

/**
 * A problem of allocating work to boats.
 *
 * @param boats in the order that decides ties: the earlier boat wins
 * @param work the work, without what boats have begun already; names are unique, locations need not be
 * @param ways lengths of ways around obstacles; straight lines where empty
 */
public record AllocationProblem(List<Candidate> boats, List<WorkItem> work, Optional<WayLengths> ways) {
    /** A problem in open water. */
    public AllocationProblem(List<Candidate> boats, List<WorkItem> work) {
        this(boats, work, Optional.empty());
    }

    public AllocationProblem {
        boats = List.copyOf(boats);
        work = List.copyOf(work);
        unique("boat", boats.stream().map(Candidate::boat).toList());
        unique("work", work.stream().map(WorkItem::name).toList());
        if (boats.isEmpty() && !work.isEmpty()) {
            throw new IllegalArgumentException(
                    "There is no boat to which " + work.size() + " locations could be allocated");
        }
    }

    private static void unique(String what, List<String> names) {
        Set<String> seen = new HashSet<>();
        names.stream().filter(name -> !seen.add(name)).findFirst().ifPresent(twice -> {
            throw new IllegalArgumentException("Two of the same name among the " + what + ": " + twice);
        });
    }

    /** Locations that any of the boats can visit; the same point twice is two locations. */
    public static AllocationProblem ofVisits(Map<String, GeoPoint> boats, List<GeoPoint> locations) {
        List<Candidate> candidates = new ArrayList<>();
        boats.forEach((boat, at) -> candidates.add(Candidate.at(boat, at)));
        List<WorkItem> visits = new ArrayList<>();
        locations.forEach(location -> visits.add(WorkItem.visit("location " + (visits.size() + 1), location)));
        return new AllocationProblem(candidates, visits);
    }

    /** The same problem in this water: ways lead around forbidden areas, and a boat gets only work that it can reach. Measures all ways. */
    public AllocationProblem in(Water water) {
        List<GeoPoint> points = new ArrayList<>();
        for (Candidate boat : boats) {
            points.add(boat.at());
            boat.begun().forEach(one -> points.add(one.location()));
        }
        work.forEach(one -> points.add(one.location()));
        return water.isOpen()
                ? this
                : new AllocationProblem(boats, work, Optional.of(WayLengths.between(points, water)));
    }

    /** The same for boats that turn on the spot. */
    AllocationProblem turningOnTheSpot() {
        return new AllocationProblem(
                boats.stream().map(boat -> boat.turningIn(0)).toList(), work, ways);
    }

    /** Whether a boat offers what some work needs and can get to it. */
    boolean canDo(Candidate boat, WorkItem one) {
        return boat.canDo(one)
                && ways.map(lengths -> lengths.lengthM(boat.freeAt(), one.location()) < Double.POSITIVE_INFINITY)
                        .orElse(true);
    }

    /** The length of a boat's path along the surface, or around what is in between, in metres. */
    double lengthM(Candidate boat, List<GeoPoint> path) {
        return ways.map(lengths -> lengths.lengthM(boat.at(), path)).orElseGet(() -> Geodesy.lengthM(boat.at(), path));
    }

    /** How much longer each metre takes a boat than the fastest one: 1 for the fastest, and for a boat whose speed is not known. */
    double slowness(Candidate boat) {
        double fastestMps = boats.stream()
                .flatMapToDouble(one -> one.speedMps().stream())
                .max()
                .orElse(1);
        return boat.speedMps().isPresent() ? fastestMps / boat.speedMps().getAsDouble() : 1;
    }

    /** The work that no boat can do, and what is missing for it. */
    public List<Unallocated> impossible() {
        return work.stream()
                .filter(one -> boats.stream().noneMatch(boat -> canDo(boat, one)))
                .map(one -> new Unallocated(one, missing(one)))
                .toList();
    }

    /** The same without the work that no boat can do. */
    public AllocationProblem possible() {
        return new AllocationProblem(
                boats,
                work.stream()
                        .filter(one -> boats.stream().anyMatch(boat -> canDo(boat, one)))
                        .toList(),
                ways);
    }

    private Set<String> missing(WorkItem one) {
        if (boats.stream().anyMatch(boat -> boat.canDo(one))) {
            return Set.of();
        }
        Set<String> offered = new HashSet<>();
        boats.forEach(boat -> offered.addAll(boat.offers()));
        Set<String> missing = new TreeSet<>(one.needs());
        missing.removeAll(offered);
        return missing.isEmpty() ? one.needs() : missing;
    }
}
