package org.sami.dreamm.palette;

import java.util.HashSet;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import org.sami.dreamm.context.DreammContext;
import org.sami.spn.edit.Edit;
import org.sami.spn.edit.TaskEdit;
import org.sami.spn.model.Plan;
import org.sami.spn.model.TaskSpec;
import org.sami.spn.vocabulary.Direction;
import org.sami.spn.wizard.AddVertex;
import org.sami.spn.wizard.EventTarget;

/** Makes the edits that add items of a palette to the open plan, and says where an item cannot go. Knows no Swing. */
final class PaletteEdits {
    private final DreammContext context;

    PaletteEdits(DreammContext context) {
        this.context = Objects.requireNonNull(context, "context");
    }

    /** Why an item cannot go to a target, in one sentence; empty where it can. */
    Optional<String> refusal(PaletteItem item, EventTarget target) {
        Optional<Plan> open = context.editor().plan();
        if (open.isEmpty()) {
            return Optional.of("No plan is open");
        }
        Optional<String> locked = locked(context, item);
        if (locked.isPresent()) {
            return locked;
        }
        if (item instanceof PaletteItem.Event event) {
            return target.refusal(open.get(), event.type());
        }
        if (item instanceof PaletteItem.Role) {
            return target instanceof EventTarget.OnVertex
                    ? Optional.of(
                            "A role is a task of the whole plan: drop it onto free space, or onto an edge that asks for it")
                    : Optional.empty();
        }
        return AddVertex.refusal(open.get(), content(item), target);
    }

    /** Why the profile keeps an item from being added; empty where it does not. */
    static Optional<String> locked(DreammContext context, PaletteItem item) {
        return new PaletteGroups(context, each -> true)
                .idsOf(item).stream()
                        .flatMap(id -> context.profile().whyLocked(id).stream())
                        .findFirst()
                        .map(why -> item.label() + ": " + why);
    }

    /** The edit that adds an item to the open plan. */
    Edit edit(PaletteItem item, EventTarget target) {
        Plan plan = context.editor().plan().orElseThrow();
        if (item instanceof PaletteItem.Event event) {
            return context.additions().event(event.type().name(), target);
        }
        if (item instanceof PaletteItem.Role role) {
            String taskClass = role.taskClass().name();
            String name = freshTask(plan, taskClass);
            return new TaskEdit.AddTask(plan.id(), new TaskSpec(name, taskClass, Map.of()));
        }
        return new AddVertex(
                plan.id(),
                content(item),
                target,
                context.additions().mode(),
                context.additions().library());
    }

    /** Where an item goes that is added without saying where. */
    EventTarget target(PaletteItem item) {
        boolean ontoPlaces = item instanceof PaletteItem.Event event
                ? event.type().direction() == Direction.OUTPUT
                : item instanceof PaletteItem.SubMission;
        EventTarget target = context.additions().target(ontoPlaces);
        boolean blank = item instanceof PaletteItem.BlankPlace || item instanceof PaletteItem.BlankTransition;
        return blank && target instanceof EventTarget.OnVertex on ? new EventTarget.Behind(on.vertex()) : target;
    }

    private static AddVertex.Content content(PaletteItem item) {
        if (item instanceof PaletteItem.SubMission sub) {
            return new AddVertex.Content.SubMission(sub.plan(), sub.label());
        }
        return item instanceof PaletteItem.BlankPlace
                ? new AddVertex.Content.BlankPlace()
                : new AddVertex.Content.BlankTransition();
    }

    /** A name for a task that the plan does not have yet. */
    static String freshTask(Plan plan, String word) {
        Set<String> taken = new HashSet<>();
        plan.tasks().forEach(t -> taken.add(t.name()));
        String name = word;
        for (int n = 2; taken.contains(name); n++) {
            name = word + " " + n;
        }
        return name;
    }
}
