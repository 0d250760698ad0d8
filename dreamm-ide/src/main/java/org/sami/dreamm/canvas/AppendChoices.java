package org.sami.dreamm.canvas;

import java.util.List;
import org.sami.spn.edit.Edit;
import org.sami.spn.model.LayoutPoint;
import org.sami.spn.model.Mode;
import org.sami.spn.model.Plan;

/** Knows what can come next at a vertex. */
@FunctionalInterface
public interface AppendChoices {
    /** What can come next, the likeliest first; nothing where nothing is known. */
    List<NextStep> after(Plan plan, String vertex);

    /** One thing that can come next. */
    interface NextStep {
        /** What it is, in a few words. */
        String label();

        /**
         * The edit that adds it behind a vertex.
         *
         * @param at where a new vertex has room, in units of the plan's layout
         * @param mode of what is made
         */
        Edit edit(Plan plan, String vertex, LayoutPoint at, Mode mode);
    }
}
