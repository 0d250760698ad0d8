package org.sami.crw.service.allocation;

import java.util.Locale;
import java.util.Set;
import java.util.TreeSet;

/**
 * Work that no boat can do.
 *
 * @param missing the capabilities that are missing: those that no boat offers, or where each is offered by some boat all that
 *     the work needs, as no single boat offers them together; none where boats offer them that have no way to it
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
                    "%s, at %.5f,%.5f, is unallocated: no boat that can do it has a way there, around what is to be avoided",
                    work.name(),
                    work.location().latDeg(),
                    work.location().lonDeg());
        }
        return work.name() + " is unallocated: no boat offers " + String.join(" and ", missing)
                + (missing.size() > 1 ? " together" : "");
    }
}
