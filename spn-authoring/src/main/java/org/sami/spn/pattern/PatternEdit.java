package org.sami.spn.pattern;

import java.util.Objects;
import org.sami.spn.edit.EditContext;
import org.sami.spn.edit.EditRefusedException;
import org.sami.spn.edit.PlanEdit;
import org.sami.spn.model.Plan;

/** Draws a pattern into a plan. */
record PatternEdit(String plan, String label, Drawing drawing) implements PlanEdit {
    /** What is drawn. */
    @FunctionalInterface
    interface Drawing {
        Plan drawn(Plan plan, EditContext context) throws EditRefusedException;
    }

    PatternEdit {
        Objects.requireNonNull(plan, "plan");
        Objects.requireNonNull(label, "label");
        Objects.requireNonNull(drawing, "drawing");
    }

    @Override
    public Plan change(Plan before, EditContext context) throws EditRefusedException {
        return drawing.drawn(before, context);
    }
}
