package org.sami.dreamm.canvas;

import java.util.Optional;
import org.sami.spn.edit.Edit;
import org.sami.spn.model.LayoutPoint;
import org.sami.spn.model.Mode;
import org.sami.spn.model.Plan;

/** Something that can be put onto a net: an event, a sub-mission, a role, a blank vertex. It says itself which edit that is. */
public interface NetDrop {
    /** What it is, in a few words. */
    String label();

    /** Why it cannot be added to a vertex, in one sentence; empty where it can. */
    Optional<String> whyNotOnto(Plan plan, String vertex);

    /**
     * The edit that adds it to a vertex to which it can be added.
     *
     * @param mode of the places or transitions made in addition
     */
    Edit onto(Plan plan, String vertex, Mode mode);

    /** The edit that adds it to an edge; empty where edges hold no such thing, and it lies on free space there. */
    default Optional<Edit> ontoEdge(Plan plan, String edge) {
        return Optional.empty();
    }

    /**
     * The edit that adds it with a vertex of its own.
     *
     * @param at where, in units of the plan's layout
     * @param mode of what is made
     */
    Edit at(Plan plan, LayoutPoint at, Mode mode);
}
