package org.sami.crw.service.allocation;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;

/**
 * The problem that is left when the team changes while it works. Every boat keeps what it has begun; what is not begun is divided
 * anew among those that are there now, so a boat that left loses its work, begun or not, and one that returned gets a share.
 */
public final class Reassignment {
    private Reassignment() {}

    /**
     * The problem of dividing anew.
     *
     * @param present the boats that are there now; what each has begun is taken from here
     * @param paths the paths of the allocation up to now, without what is done; also of boats that left
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
