package org.sami.crw.service.allocation;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;

/**
 * The problem that remains when the team changes during the work. Every boat keeps the work that it has begun. The rest is divided among the boats
 * present now: a boat that left loses its work, begun or not, and a boat that returned gets a share.
 */
public final class Reassignment {
    private Reassignment() {}

    /**
     * The problem of dividing the rest.
     *
     * @param present the boats present now, with the work that each has begun
     * @param paths the present paths without finished work, also those of boats that left
     */
    public static AllocationProblem of(List<Candidate> present, Map<String, List<WorkItem>> paths) {
        Set<String> kept = new LinkedHashSet<>();
        present.forEach(boat -> boat.begun().forEach(work -> kept.add(work.name())));
        List<WorkItem> open = new ArrayList<>();
        Map<String, WorkItem> seen = new HashMap<>();
        paths.values()
                .forEach(path -> path.forEach(work -> {
                    if (!kept.contains(work.name()) && seen.put(work.name(), work) == null) {
                        open.add(work);
                    }
                }));
        return new AllocationProblem(present, open);
    }
}
