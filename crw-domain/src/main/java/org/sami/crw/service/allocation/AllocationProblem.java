package org.sami.crw.service.allocation;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import org.sami.spn.value.GeoPoint;

/**
 * What is to be allocated to whom.
 *
 * @param boats their order decides ties, the earlier boat wins
 * @param work what is to be done, without what boats have begun already; names are unique, locations need not be
 */
public record AllocationProblem(List<Candidate> boats, List<WorkItem> work) {
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

    /** The work that no boat can do, and what is missing for it. */
    public List<Unallocated> impossible() {
        return work.stream()
                .filter(one -> boats.stream().noneMatch(boat -> boat.canDo(one)))
                .map(one -> new Unallocated(one, missing(one)))
                .toList();
    }

    /** The same without the work that no boat can do. */
    public AllocationProblem possible() {
        return new AllocationProblem(
                boats,
                work.stream()
                        .filter(one -> boats.stream().anyMatch(boat -> boat.canDo(one)))
                        .toList());
    }

    private Set<String> missing(WorkItem one) {
        Set<String> offered = new HashSet<>();
        boats.forEach(boat -> offered.addAll(boat.offers()));
        Set<String> missing = new TreeSet<>(one.needs());
        missing.removeAll(offered);
        return missing.isEmpty() ? one.needs() : missing;
    }
}
