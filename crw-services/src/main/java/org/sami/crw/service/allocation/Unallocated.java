package org.sami.crw.service.allocation;

import java.util.Locale;
import java.util.Set;
import java.util.TreeSet;

/**
 * Work that no boat can do.
 *
 * @param missing the missing capabilities: those that no boat offers; all that the work needs, where boats offer them only separately; none,
 *     where the boats that offer them cannot reach the work
 */
public record Unallocated(WorkItem work, Set<String> missing) {
    public Unallocated {
        missing = java.util.Collections.unmodifiableSet(new TreeSet<>(missing));
    }

    /** The fact as people say it; names the work and what is missing. */
    public String words() {
        if (missing.isEmpty()) {
            return String.format(
                    Locale.ROOT,
                    "%s, at %.5f,%.5f, is unallocated: no boat that can do it has a way there around no-go areas",
                    work.name(),
                    work.location().latDeg(),
                    work.location().lonDeg());
        }
        return work.name() + " is unallocated: no boat offers " + String.join(" and ", missing)
                + (missing.size() > 1 ? " together" : "");
    }
}
