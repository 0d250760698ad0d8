package org.sami.dreamm.document;

import java.util.Collections;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;

/**
 * What became of the document.
 *
 * @param before the project as it was
 * @param after the project as it is
 * @param plans ids of the plans that were changed, added or removed; the others are the same objects as before
 * @param remarks sentences for the author about parts that were removed along with others, or still refer to removed ones
 */
public record DocumentChange(Cause cause, Project before, Project after, Set<String> plans, List<String> remarks) {
    /** Why the document is another one. */
    public enum Cause {
        /** Another project was opened, or a new one begun. */
        OPENED,
        /** An edit was made. */
        EDITED,
        /** An edit was taken back. */
        UNDONE,
        /** An edit that was taken back was made again. */
        REDONE
    }

    public DocumentChange {
        Objects.requireNonNull(cause, "cause");
        Objects.requireNonNull(before, "before");
        Objects.requireNonNull(after, "after");
        plans = Collections.unmodifiableSet(new LinkedHashSet<>(plans));
        remarks = List.copyOf(remarks);
    }

    /** Whether another project was opened: nothing that was known of the one before holds. */
    public boolean isOpened() {
        return cause == Cause.OPENED;
    }

    /** Ids of a plan's places, transitions and edges that differ, were added or are gone, in the order of the document. */
    public Set<String> elements(String plan) {
        Map<String, Object> old = new HashMap<>();
        before.plan(plan).ifPresent(p -> collect(p, old));
        Map<String, Object> now = new java.util.LinkedHashMap<>();
        after.plan(plan).ifPresent(p -> collect(p, now));
        Set<String> differ = new LinkedHashSet<>();
        now.forEach((id, element) -> {
            if (!element.equals(old.remove(id))) {
                differ.add(id);
            }
        });
        differ.addAll(old.keySet());
        return differ;
    }

    private static void collect(Plan plan, Map<String, Object> elements) {
        plan.places().forEach(p -> elements.put(p.id(), p));
        plan.transitions().forEach(t -> elements.put(t.id(), t));
        plan.inEdges().forEach(e -> elements.put(e.id(), e));
        plan.outEdges().forEach(e -> elements.put(e.id(), e));
    }
}
