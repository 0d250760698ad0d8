package org.sami.dreamm.inspector;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;
import org.sami.dreamm.context.DreammContext;
import org.sami.dreamm.help.Explained;
import org.sami.dreamm.help.HelpTopic;
import org.sami.dreamm.help.HelpTopics;
import org.sami.palette.SemanticColor;
import org.sami.spn.edit.EventEdit;
import org.sami.spn.model.InputEventSpec;
import org.sami.spn.model.MarkupSpec;
import org.sami.spn.model.OutputEventSpec;
import org.sami.spn.vocabulary.EventType;
import org.sami.spn.wizard.RemoveWithRequirements;

/** One event of a vertex: what it is, its fields and its markup, with buttons that order, reset and delete it. */
final class EventCard extends Form implements Explained {
    private final transient DreammContext context;
    private final transient Scope scope;
    private final transient EventType type;

    /** An output event. */
    EventCard(DreammContext context, Scope scope, OutputEventSpec spec, int index) {
        this.context = context;
        this.scope = scope;
        type = context.vocabulary().event(spec.type()).orElseThrow();
        head(
                "→ ",
                spec.id(),
                index,
                () -> context.apply(new EventEdit.ChangeOutput(
                        scope.plan().id(),
                        new OutputEventSpec(spec.id(), spec.type(), Map.of(), Map.of(), List.of()))));
        type.fields().forEach(field -> wide(FieldRow.of(context, scope, spec, type, field)));
        markups(spec.id(), spec.markups());
    }

    /** An input event. */
    EventCard(DreammContext context, Scope scope, InputEventSpec spec, int index) {
        this.context = context;
        this.scope = scope;
        type = context.vocabulary().event(spec.type()).orElseThrow();
        head(
                "← ",
                spec.id(),
                index,
                () -> context.apply(new EventEdit.ChangeInput(
                        scope.plan().id(), new InputEventSpec(spec.id(), spec.type(), Map.of(), Map.of(), List.of()))));
        type.fields().forEach(field -> wide(FieldRow.of(context, scope, spec, type, field)));
        markups(spec.id(), spec.markups());
    }

    private void head(String mark, String id, int index, Runnable reset) {
        setName("event-" + index);
        heading(mark + type.label());
        note(type.help(), SemanticColor.MUTED);
        JPanel head = new JPanel(new MigLayout("novisualpadding, insets 0, gap 2"));
        head.setOpaque(false);
        String plan = scope.plan().id();
        if (index > 0) {
            head.add(button(
                    "↑",
                    "event-" + index + "-up",
                    "Move the event up",
                    () -> context.apply(new EventEdit.MoveEvent(plan, id, index - 1))));
        }
        head.add(button("Reset", "event-" + index + "-reset", "Take away its fields, variables and markup", reset));
        head.add(button(
                "Delete",
                "event-" + index + "-delete",
                "Delete the event, and what only it needed",
                () -> context.apply(new RemoveWithRequirements(
                        plan, Set.of(id), context.additions().library()))));
        wide(head);
    }

    @Override
    public Optional<HelpTopic> help() {
        return Optional.of(
                new HelpTopics(context.vocabulary(), context.additions().library()).event(type));
    }

    private void markups(String event, List<MarkupSpec> markups) {
        wide(new MarkupRows(context, scope.plan().id(), event, markups));
    }
}
