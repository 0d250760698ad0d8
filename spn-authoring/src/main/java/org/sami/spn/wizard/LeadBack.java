package org.sami.spn.wizard;

import java.util.Objects;
import java.util.Optional;
import org.sami.spn.edit.EditContext;
import org.sami.spn.edit.EditRefusedException;
import org.sami.spn.edit.PlanEdit;
import org.sami.spn.model.Mode;
import org.sami.spn.model.Plan;
import org.sami.spn.sequence.AuthoringLibrary;
import org.sami.spn.vocabulary.EventType;

/**
 * Lets an answer of a place lead to a place that is there, and adjusts the requirements of edges.
 *
 * @param place whose event is answered
 * @param answer name of the input event
 * @param transition that takes it; empty draws one
 * @param to the place that is entered
 */
public record LeadBack(
        String plan,
        String place,
        String answer,
        Optional<String> transition,
        String to,
        Mode mode,
        AuthoringLibrary library)
        implements PlanEdit {
    public LeadBack {
        Objects.requireNonNull(plan, "plan");
        Objects.requireNonNull(place, "place");
        Objects.requireNonNull(answer, "answer");
        Objects.requireNonNull(transition, "transition");
        Objects.requireNonNull(to, "to");
        Objects.requireNonNull(mode, "mode");
        Objects.requireNonNull(library, "library");
    }

    @Override
    public String label() {
        return "Let " + answer + " lead to \"" + to + "\"";
    }

    @Override
    public Plan change(Plan before, EditContext context) throws EditRefusedException {
        Optional<EventType> type = context.vocabulary().event(answer);
        if (type.isEmpty()) {
            throw new EditRefusedException("The domain has no event " + answer);
        }
        if (before.place(place).isEmpty() || before.place(to).isEmpty()) {
            throw new EditRefusedException("The plan \"" + plan + "\" has no place "
                    + (before.place(place).isEmpty() ? place : to));
        }
        Growth growth = new Growth(before, context.vocabulary(), library, mode);
        String from = transition.orElseGet(() -> {
            String drawn = growth.transition(type.get().label(), growth.behind(place));
            growth.connect(place, drawn);
            growth.input(drawn, type.get());
            return drawn;
        });
        growth.connectOut(from, to);
        return new RequirementComputation(context.vocabulary(), library).adjusted(before, growth.plan());
    }
}
