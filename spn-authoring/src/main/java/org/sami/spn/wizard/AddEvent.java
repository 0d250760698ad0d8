package org.sami.spn.wizard;

import java.util.LinkedHashSet;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import org.sami.spn.edit.EditContext;
import org.sami.spn.edit.EditRefusedException;
import org.sami.spn.edit.PlanEdit;
import org.sami.spn.flow.ComingTokens;
import org.sami.spn.flow.TokenType;
import org.sami.spn.model.Mode;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.model.TokenKind;
import org.sami.spn.model.Transition;
import org.sami.spn.model.WaitFor;
import org.sami.spn.sequence.AuthoringLibrary;
import org.sami.spn.sequence.Gathering;
import org.sami.spn.sequence.Sequence;
import org.sami.spn.vocabulary.Direction;
import org.sami.spn.vocabulary.EventType;
import org.sami.spn.wiring.Wires;

/**
 * Adds an event, draws what its sequence says, and adjusts the requirements of edges (thesis 5.1.1, Event Wizard); one step to undo.
 *
 * @param event name of the event type
 * @param mode in which new vertices and edges are drawn
 * @param sequence id of the sequence; {@link Sequence#ALONE} for the event and nothing else
 * @param wires from where the fields are read of the output events that are drawn
 */
public record AddEvent(
        String plan,
        String event,
        EventTarget target,
        Mode mode,
        String sequence,
        AuthoringLibrary library,
        Wires wires)
        implements PlanEdit {
    public AddEvent {
        Objects.requireNonNull(plan, "plan");
        Objects.requireNonNull(event, "event");
        Objects.requireNonNull(target, "target");
        Objects.requireNonNull(mode, "mode");
        Objects.requireNonNull(sequence, "sequence");
        Objects.requireNonNull(library, "library");
        Objects.requireNonNull(wires, "wires");
    }

    /** Adds an event with the sequence that its domain offers first, or alone where it has none; its fields are read from what is proposed. */
    public static AddEvent usual(String plan, String event, EventTarget target, Mode mode, AuthoringLibrary library) {
        String first = library.of(event).stream().map(Sequence::id).findFirst().orElse(Sequence.ALONE);
        return new AddEvent(plan, event, target, mode, first, library, Wires.PROPOSED);
    }

    /** The same with another sequence. */
    public AddEvent withSequence(String id) {
        return new AddEvent(plan, event, target, mode, id, library, wires);
    }

    /** The same with fields that are read from elsewhere. */
    public AddEvent withWires(Wires others) {
        return new AddEvent(plan, event, target, mode, sequence, library, others);
    }

    @Override
    public Project change(Project project, EditContext context) throws EditRefusedException {
        Project drawn = PlanEdit.super.change(project, context);
        Project added = gathering(library.sequence(event, sequence)) == Gathering.EACH_THEN_TOGETHER
                ? met(project, drawn, context)
                : drawn;
        return wires.wired(project, added, plan, event, library::wired, context);
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
            growth.gather(gathering(chosen));
            grown = grown(growth, type, chosen.isPresent());
        }
        return new RequirementComputation(context.vocabulary(), library).adjusted(before, grown);
    }

    private static Gathering gathering(Optional<Sequence> sequence) {
        return sequence.isPresent() && sequence.get() instanceof Sequence.Gathered gathered
                ? gathered.gathering()
                : Gathering.WAIT_FOR_ALL;
    }

    /** Draws the transition that fires when all have come who were in the places of a transition that takes answers one by one. */
    private Project met(Project project, Project added, EditContext context) {
        Plan before = project.plan(plan).orElseThrow();
        Plan after = added.plan(plan).orElseThrow();
        ComingTokens coming = new ComingTokens(added, after, context.vocabulary());
        Plan met = after;
        for (Transition t : answering(before, after)) {
            Set<String> from = new LinkedHashSet<>();
            after.inEdgesOf(t.id()).forEach(e -> from.add(e.place()));
            boolean tasks = from.stream().anyMatch(p -> coming.comes(TokenType.TASK, p));
            met = new InhibitedTransition(
                            after.outEdgesOf(t.id()).get(0).place(),
                            from,
                            tasks ? TokenKind.ANY_TASK : TokenKind.ANY_PROXY,
                            "All here",
                            "All together",
                            false,
                            mode)
                    .drawn(met);
        }
        Plan drawn = met;
        return added.withPlans(
                added.plans().stream().map(p -> p.id().equals(plan) ? drawn : p).toList());
    }

    private List<Transition> answering(Plan before, Plan after) {
        return after.transitions().stream()
                .filter(t -> !t.inputs()
                        .equals(before.transition(t.id())
                                .map(Transition::inputs)
                                .orElse(List.of())))
                .filter(t -> t.inputs().stream()
                        .anyMatch(i -> library.ofInput(i.type())
                                .filter(s -> s.waitFor() == WaitFor.ALL)
                                .isPresent()))
                .filter(t -> !after.inEdgesOf(t.id()).isEmpty()
                        && !after.outEdgesOf(t.id()).isEmpty())
                .toList();
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
