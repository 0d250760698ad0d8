package org.sami.dreamm.canvas;

import java.util.LinkedHashSet;
import java.util.Optional;
import java.util.Set;
import java.util.function.BiFunction;
import org.sami.dreamm.context.DreammContext;
import org.sami.picture.net.NetMode;
import org.sami.spn.drawing.NetDrawing.Kind;
import org.sami.spn.edit.Edit;
import org.sami.spn.edit.ExtractSubMission;
import org.sami.spn.edit.SetDisabled;
import org.sami.spn.edit.SetMode;
import org.sami.spn.edit.VertexEdit;
import org.sami.spn.model.DisabledParts;
import org.sami.spn.model.Mode;
import org.sami.spn.model.Plan;

/** The commands that change what the selected elements are: start, end, recovery part, part of a sub-mission. */
final class ElementRoleCommands {
    private final DreammContext context;
    private final ShownNet net;
    private final NetActions actions;
    private final NetCommands commands;

    ElementRoleCommands(DreammContext context, ShownNet net, NetActions actions, NetCommands commands) {
        this.context = context;
        this.net = net;
        this.actions = actions;
        this.commands = commands;
    }

    void add() {
        commands.add(
                "net-set-start",
                "Start here",
                () -> applyToVertex((plan, id) -> new VertexEdit.SetStart(plan, id)),
                this::whyNotPlace,
                "S");
        commands.add(
                "net-set-end",
                "End here, or not",
                () -> applyToVertex((plan, id) -> {
                    boolean end = net.plan().place(id).orElseThrow().end();
                    return new VertexEdit.SetEnd(plan, id, !end, false);
                }),
                this::whyNotPlace,
                "shift S");
        commands.add(
                "net-mark-recovery",
                "Make it a recovery part",
                () -> mark(Mode.RECOVERY),
                commands.selected("net-mark-recovery"),
                "Y");
        commands.add(
                "net-mark-nominal",
                "Make it a nominal part",
                () -> mark(Mode.NOMINAL),
                commands.selected("net-mark-nominal"),
                "shift Y");
        commands.add(
                "net-disable",
                "Disable for trying, or enable again",
                this::disable,
                commands.vertices("net-disable", 1),
                "ctrl E");
        commands.add(
                "net-extract",
                "Extract to a sub-mission",
                this::extract,
                () -> actions.whyNotEdit("net-extract")
                        .or(() -> ExtractSubMission.whyNot(net.plan(), actions.selection(), context.vocabulary())),
                "X");
        commands.add(
                "net-recovery",
                "Nominal or recovery mode",
                () -> context.editor()
                        .setMode(context.editor().mode() == NetMode.RECOVERY ? NetMode.NOMINAL : NetMode.RECOVERY),
                Optional::empty,
                "R");
    }

    private void applyToVertex(BiFunction<String, String, Edit> edit) {
        actions.apply(edit.apply(
                net.plan().id(), actions.selectedVertex().orElseThrow().id()));
    }

    private Optional<String> whyNotPlace() {
        return actions.whyNotEdit("net-set-start")
                .or(() -> actions.selectedVertex()
                                .filter(vertex -> vertex.kind() == Kind.PLACE)
                                .isPresent()
                        ? Optional.empty()
                        : Optional.of("select one place"));
    }

    private void mark(Mode mode) {
        Set<String> elements = new LinkedHashSet<>();
        Plan plan = net.plan();
        plan.places().forEach(p -> elements.add(p.id()));
        plan.transitions().forEach(t -> elements.add(t.id()));
        plan.inEdges().forEach(e -> elements.add(e.id()));
        plan.outEdges().forEach(e -> elements.add(e.id()));
        elements.retainAll(actions.selection());
        actions.apply(new SetMode(plan.id(), elements, mode));
    }

    /** Disables the selected vertices; enables them where all of them are disabled. */
    private void disable() {
        Plan plan = net.plan();
        Set<String> vertices = new LinkedHashSet<>();
        plan.places().forEach(p -> vertices.add(p.id()));
        plan.transitions().forEach(t -> vertices.add(t.id()));
        vertices.retainAll(actions.selection());
        boolean all = DisabledParts.of(plan).containsAll(vertices);
        actions.apply(new SetDisabled(plan.id(), vertices, !all));
    }

    private void extract() {
        Plan plan = net.plan();
        int n = 1;
        while (context.document().plan(plan.id() + "-part-" + n).isPresent()) {
            n++;
        }
        String id = plan.id() + "-part-" + n;
        Set<String> before = new LinkedHashSet<>();
        plan.places().forEach(p -> before.add(p.id()));
        if (actions.apply(actions.edits()
                .keepingTheRest(
                        new ExtractSubMission(plan.id(), actions.selection(), id, plan.title() + ", part " + n)))) {
            net.plan().places().stream()
                    .map(p -> p.id())
                    .filter(place -> !before.contains(place))
                    .findFirst()
                    .ifPresent(place -> context.editor().select(Set.of(place)));
        }
    }
}
