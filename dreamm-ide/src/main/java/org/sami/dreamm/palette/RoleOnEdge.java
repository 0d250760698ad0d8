package org.sami.dreamm.palette;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.sami.spn.edit.EdgeEdit;
import org.sami.spn.edit.Edit;
import org.sami.spn.edit.EditSequence;
import org.sami.spn.edit.TaskEdit;
import org.sami.spn.model.Action;
import org.sami.spn.model.InEdge;
import org.sami.spn.model.InRequirement;
import org.sami.spn.model.Match;
import org.sami.spn.model.OutEdge;
import org.sami.spn.model.OutRequirement;
import org.sami.spn.model.Plan;
import org.sami.spn.model.TaskSpec;
import org.sami.spn.model.TokenKind;

/**
 * A role that is dropped onto an edge: the plan's task of that class, which is declared where the plan has none, is asked for there or taken
 * along. Knows no Swing.
 */
final class RoleOnEdge {
    private RoleOnEdge() {}

    /** The edit; empty where the plan has no such edge. */
    static Optional<Edit> of(Plan plan, String taskClass, String edge) {
        Optional<TaskSpec> there = plan.tasks().stream()
                .filter(task -> task.taskClass().equals(taskClass))
                .findFirst();
        TaskSpec task =
                there.orElseGet(() -> new TaskSpec(PaletteEdits.freshTask(plan, taskClass), taskClass, Map.of()));
        return requirement(plan, task.name(), edge).map(asked -> {
            List<Edit> edits = new ArrayList<>();
            if (there.isEmpty()) {
                edits.add(new TaskEdit.AddTask(plan.id(), task));
            }
            edits.add(asked);
            return new EditSequence("Ask for the task " + task.name(), edits);
        });
    }

    private static Optional<Edit> requirement(Plan plan, String task, String edge) {
        Optional<InEdge> in =
                plan.inEdges().stream().filter(e -> e.id().equals(edge)).findFirst();
        if (in.isPresent()) {
            List<InRequirement> all = new ArrayList<>(in.get().requirements());
            all.removeIf(r -> r.kind() == TokenKind.UNCONDITIONAL);
            all.add(new InRequirement(TokenKind.TASK, Match.AT_LEAST, 1, task));
            return Optional.of(new EdgeEdit.SetInRequirements(plan.id(), edge, all));
        }
        return plan.outEdges().stream()
                .filter(e -> e.id().equals(edge))
                .findFirst()
                .map(OutEdge::requirements)
                .map(requirements -> {
                    List<OutRequirement> all = new ArrayList<>(requirements);
                    all.removeIf(r -> r.kind() == TokenKind.UNCONDITIONAL);
                    all.add(new OutRequirement(TokenKind.TASK, 1, Action.TAKE, task));
                    return new EdgeEdit.SetOutRequirements(plan.id(), edge, all);
                });
    }
}
