package org.sami.spn.wizard;

import java.util.Objects;
import java.util.Optional;
import org.sami.spn.edit.EditContext;
import org.sami.spn.edit.EditRefusedException;
import org.sami.spn.edit.PlanEdit;
import org.sami.spn.model.Mode;
import org.sami.spn.model.Plan;
import org.sami.spn.vocabulary.Direction;
import org.sami.spn.vocabulary.EventType;

/**
 * Adds an event, draws what its sequence says, and adjusts the requirements of edges (thesis 5.1.1, Event Wizard); one step to undo.
 *
 * @param event name of the event type
 * @param mode in which new vertices and edges are drawn
 * @param sequence id of the sequence; {@link Sequence#ALONE} for the event and nothing else
 */
public record AddEvent(
        String plan, String event, EventTarget target, Mode mode, String sequence, AuthoringLibrary library)
        implements PlanEdit {
    public AddEvent {
        Objects.requireNonNull(plan, "plan");
        Objects.requireNonNull(event, "event");
        Objects.requireNonNull(target, "target");
        Objects.requireNonNull(mode, "mode");
        Objects.requireNonNull(sequence, "sequence");
        Objects.requireNonNull(library, "library");
    }

    /** Adds an event with the sequence that its domain offers first, or alone where it has none. */
    public static AddEvent usual(String plan, String event, EventTarget target, Mode mode, AuthoringLibrary library) {
        String first = library.of(event).stream().map(Sequence::id).findFirst().orElse(Sequence.ALONE);
        return new AddEvent(plan, event, target, mode, first, library);
    }

    /** The same with another sequence. */
    public AddEvent withSequence(String id) {
        return new AddEvent(plan, event, target, mode, id, library);
    }

    @Override
    public String label() {
        return "Add " + event + (target instanceof EventTarget.OnVertex on ? " to \"" + on.vertex() + "\"" : "");
    }

    @Override
    public Plan change(Plan before, EditContext context) throws EditRefusedException {
        Optional<EventType> known = context.vocabulary().event(event);
        if (known.isEmpty()) {
            throw new EditRefusedException("The domain has no event " + event);
        }
        EventType type = known.get();
        Optional<String> refusal = target.refusal(before, type);
        if (refusal.isPresent()) {
            throw new EditRefusedException(refusal.get());
        }
        Optional<Sequence> chosen = library.sequence(type.name(), sequence);
        if (chosen.isEmpty() && !sequence.equals(Sequence.ALONE)) {
            throw new EditRefusedException("The event " + type.name() + " has no sequence " + sequence);
        }
        Growth growth = new Growth(before, context.vocabulary(), library, mode);
        Plan grown;
        if (chosen.isPresent() && chosen.get() instanceof Sequence.Manual manual) {
            String vertex = vertex(growth, type);
            grown = new ManualDrawing(manual, mode, context).drawn(growth.plan(), vertex);
        } else {
            grown = grown(growth, type, chosen.isPresent());
        }
        return new RequirementComputation(context.vocabulary(), library).adjusted(before, grown);
    }

    private Plan grown(Growth growth, EventType type, boolean follow) {
        String vertex = vertex(growth, type);
        if (type.direction() == Direction.OUTPUT) {
            growth.output(vertex, type);
            if (follow) {
                growth.followOutput(vertex, type.name());
            }
        } else {
            growth.input(vertex, type);
            if (follow) {
                growth.followInput(vertex, type.name());
            }
        }
        return growth.plan();
    }

    private String vertex(Growth growth, EventType type) {
        return Placement.vertex(growth, target, type.direction() == Direction.OUTPUT, type.label());
    }
}
