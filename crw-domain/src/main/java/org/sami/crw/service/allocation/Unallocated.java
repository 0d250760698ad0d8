package org.sami.crw.service.allocation;

import java.util.Set;
import java.util.TreeSet;

/**
 * Work that no boat can do.
 *
 * @param missing the capabilities that are missing: those that no boat offers, or where each is offered by some boat all that
 *     the work needs, as no single boat offers them together
 */
public record Unallocated(WorkItem work, Set<String> missing) {
    public Unallocated {
        missing = java.util.Collections.unmodifiableSet(new TreeSet<>(missing));
    }

    /** The fact as people say it; names the work and what is missing. */
    public String words() {
        return work.name() + " is unallocated: no boat offers " + String.join(" and ", missing)
                + (missing.size() > 1 ? " together" : "");
    }
}
