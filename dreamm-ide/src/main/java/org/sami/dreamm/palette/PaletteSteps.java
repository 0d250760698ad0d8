package org.sami.dreamm.palette;

import java.util.List;
import java.util.Locale;
import java.util.Objects;
import java.util.Optional;
import java.util.stream.Stream;
import org.sami.dreamm.canvas.AppendChoices;
import org.sami.dreamm.context.DreammContext;
import org.sami.spn.edit.Edit;
import org.sami.spn.model.LayoutPoint;
import org.sami.spn.model.Mode;
import org.sami.spn.model.Plan;
import org.sami.spn.sequence.Sequence;
import org.sami.spn.wizard.AddEvent;
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
                .at(plan, vertex).stream().flatMap(this::steps).toList();
    }

    /** One step, or one for each way to go on where answers come one by one. */
    private Stream<NextStep> steps(NextEvents.Next next) {
        List<Sequence> ways = context.additions().library().of(next.event().name()).stream()
                .filter(Sequence.Gathered.class::isInstance)
                .toList();
        return next.drawn() || ways.isEmpty()
                ? Stream.of(new Step(next, Optional.empty()))
                : ways.stream().map(way -> new Step(next, Optional.of(way)));
    }

    private final class Step implements NextStep {
        private final NextEvents.Next next;
        private final Optional<Sequence> way;

        Step(NextEvents.Next next, Optional<Sequence> way) {
            this.next = next;
            this.way = way;
        }

        @Override
        public String label() {
            return next.event().label()
                    + way.map(w -> ": " + w.name().toLowerCase(Locale.ROOT)).orElse("")
                    + (next.drawn() ? "  (drawn already)" : "");
        }

        @Override
        public Edit edit(Plan plan, String vertex, LayoutPoint at, Mode mode) {
            AddEvent usual = context.additions().event(next.event().name(), new EventTarget.Behind(vertex));
            return context.additions()
                    .noted(way.map(Sequence::id).map(usual::withSequence).orElse(usual));
        }
    }
}
