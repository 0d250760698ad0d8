package org.sami.dreamm.palette;

import java.util.List;
import java.util.Objects;
import org.sami.dreamm.canvas.AppendChoices;
import org.sami.dreamm.context.DreammContext;
import org.sami.spn.edit.Edit;
import org.sami.spn.model.LayoutPoint;
import org.sami.spn.model.Mode;
import org.sami.spn.model.Plan;
import org.sami.spn.wizard.EventTarget;
import org.sami.spn.wizard.NextEvents;

/** What can come next at a vertex: what its events can cause, by the vocabulary, and what usually follows them, by the domain's sequences. */
public final class PaletteSteps implements AppendChoices {
    private final DreammContext context;

    /** The steps of the plan that is open. */
    public PaletteSteps(DreammContext context) {
        this.context = Objects.requireNonNull(context, "context");
    }

    @Override
    public List<NextStep> after(Plan plan, String vertex) {
        return new NextEvents(context.vocabulary(), context.additions().library())
                .at(plan, vertex).stream()
                        .map(next -> (NextStep) new Step(next))
                        .toList();
    }

    private final class Step implements NextStep {
        private final NextEvents.Next next;

        Step(NextEvents.Next next) {
            this.next = next;
        }

        @Override
        public String label() {
            return next.event().label() + (next.drawn() ? "  (drawn already)" : "");
        }

        @Override
        public Edit edit(Plan plan, String vertex, LayoutPoint at, Mode mode) {
            return context.additions()
                    .noted(new PaletteEdits(context)
                            .edit(new PaletteItem.Event(next.event()), new EventTarget.Behind(vertex)));
        }
    }
}
