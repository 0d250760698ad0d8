package org.sami.lessons.script;

import java.util.Objects;
import org.sami.spn.edit.EditContext;
import org.sami.spn.edit.EditRefusedException;
import org.sami.spn.edit.PlanEdit;
import org.sami.spn.model.Plan;

/** Makes a place an ordinary one, which no mission starts in. */
record NoStart(String plan, String place) implements PlanEdit {
    NoStart {
        Objects.requireNonNull(plan, "plan");
        Objects.requireNonNull(place, "place");
    }

    @Override
    public String label() {
        return "Do not start at \"" + place + "\"";
    }

    @Override
    public Plan change(Plan before, EditContext context) throws EditRefusedException {
        return before.withPlaces(before.places().stream()
                .map(p -> p.id().equals(place) ? p.withStart(false) : p)
                .toList());
    }
}
