package org.sami.dreamm.canvas;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.function.BiFunction;
import java.util.function.BooleanSupplier;
import java.util.function.Supplier;
import org.sami.dreamm.context.DreammContext;
import org.sami.spn.drawing.NetDrawing.Kind;
import org.sami.spn.drawing.NetDrawing.Vertex;
import org.sami.spn.edit.Edit;
import org.sami.spn.edit.ExtractSubMission;
import org.sami.spn.edit.SetMode;
import org.sami.spn.edit.VertexEdit;
import org.sami.spn.model.LayoutPoint;
import org.sami.spn.model.Mode;
import org.sami.spn.model.Plan;
import org.sami.ui.canvas.CanvasKey;
import org.sami.ui.command.Command;
import org.sami.ui.net.NetMode;
import org.sami.ui.net.NetView;

/** The commands that change the net, with their keys while the net has the focus. */
final class CanvasCommands {
    private final DreammContext context;
    private final NetView view;
    private final ShownNet net;
    private final NetActions actions;
    private final EditTool tool;
    private final Connecting connecting;
    private final BooleanSupplier cancelLayout;

    CanvasCommands(
            DreammContext context,
            NetView view,
            ShownNet net,
            NetActions actions,
            EditTool tool,
            Connecting connecting,
            BooleanSupplier cancelLayout) {
        this.context = context;
        this.view = view;
        this.net = net;
        this.actions = actions;
        this.tool = tool;
        this.connecting = connecting;
        this.cancelLayout = cancelLayout;
    }

    void add() {
        addSelecting();
        addWalking();
        addMaking();
        addCopying();
        addArranging();
        addMeaning();
    }

    private Command add(String id, String title, Runnable run, Supplier<Optional<String>> whyNot, String... keys) {
        Command command = context.commands()
                .add(new Command(id, title, () -> {
                            view.canvas().requestFocusInWindow(); // the next key is meant for the net, too
                            run.run();
                        })
                        .withFocusKeys(CanvasKey.strokes(keys))
                        .unless(whyNot));
        command.bindTo(view.canvas());
        return command;
    }

    private Supplier<Optional<String>> open(String id) {
        return () -> actions.whyNotEdit(id);
    }

    private Supplier<Optional<String>> selected(String id) {
        return () -> actions.whyNotEdit(id)
                .or(() -> actions.selection().isEmpty() ? Optional.of("nothing is selected") : Optional.empty());
    }

    private Supplier<Optional<String>> oneVertex(String id) {
        return () -> actions.whyNotEdit(id)
                .or(() -> actions.selectedVertex().isPresent() ? Optional.empty() : Optional.of("select one vertex"));
    }

    private Supplier<Optional<String>> vertices(String id, int least) {
        return () -> actions.whyNotEdit(id)
                .or(() -> actions.edits().centres(actions.selection()).size() >= least
                        ? Optional.empty()
                        : Optional.of("select at least " + least + " vertices"));
    }

    private LayoutPoint here() {
        return tool.pointer().orElseGet(view::centre);
    }

    private void addSelecting() {
        add("net-select-all", "Select all", actions::selectAll, open("net-select-all"), "ctrl A");
        add("net-clear", "Select nothing", this::leave, Optional::empty, "ESCAPE");
        add("net-delete", "Delete", actions::delete, selected("net-delete"), "DELETE", "BACK_SPACE")
                .withIcon("clear");
        add("net-rename", "Write the name or the note", actions::rename, this::whyNotWrite, "F2")
                .withIcon("edit");
        add("net-open", "Open what is behind it", this::open, selected("net-open"), "ENTER");
    }

    private Optional<String> whyNotWrite() {
        return actions.whyNotEdit("net-rename")
                .or(() -> actions.selectedVertex().isPresent()
                                || !actions.edits().notes(actions.selection()).isEmpty()
                        ? Optional.empty()
                        : Optional.of("select one vertex or a note"));
    }

    private void leave() {
        actions.endWriting();
        if (!tool.cancel() && !cancelLayout.getAsBoolean()) {
            context.editor().select(Set.of());
        }
    }

    private void open() {
        if (connecting.isUnderWay()) {
            if (connecting.hasTarget()) {
                connecting.finish();
            }
        } else {
            actions.open(actions.selection().iterator().next());
        }
    }

    private void addWalking() {
        for (NetWalk.Direction direction : NetWalk.Direction.values()) {
            String key = direction.name();
            String way = key.toLowerCase(Locale.ROOT);
            add("net-walk-" + way, "Go " + way + " along the net", () -> walk(direction), open("net-walk"), key);
            add(
                    "net-extend-" + way,
                    "Select the vertex " + way + ", too",
                    () -> extend(direction),
                    open("net-walk"),
                    "shift " + key);
            add(
                    "net-nudge-" + way,
                    "Move " + way + " by a step of the grid",
                    () -> nudge(direction, SnapGuide.GRID),
                    selected("net-move"),
                    "ctrl " + key);
            add(
                    "net-nudge-fine-" + way,
                    "Move " + way + " a little",
                    () -> nudge(direction, 2),
                    selected("net-move"),
                    "ctrl shift " + key);
        }
    }

    private NetWalk walk() {
        List<Vertex> shown = new ArrayList<>(view.scene().vertices());
        shown.addAll(view.scene().silhouettes());
        return new NetWalk(net.drawing(), shown);
    }

    private void walk(NetWalk.Direction direction) {
        if (connecting.isUnderWay()) {
            connecting.walk(walk(), direction);
            return;
        }
        walk().next(lastSelected(), direction).ifPresent(vertex -> {
            context.editor().select(Set.of(vertex.id()));
            view.reveal(Set.of(vertex.id()));
        });
    }

    private void extend(NetWalk.Direction direction) {
        walk().next(lastSelected(), direction).ifPresent(vertex -> {
            Set<String> more = new LinkedHashSet<>(actions.selection());
            more.remove(vertex.id());
            more.add(vertex.id());
            context.editor().select(more);
            view.reveal(Set.of(vertex.id()));
        });
    }

    private String lastSelected() {
        String last = "";
        for (String id : actions.selection()) {
            last = net.vertex(id).isPresent() ? id : last;
        }
        return last;
    }

    private void nudge(NetWalk.Direction direction, double by) {
        actions.move(actions.selection(), direction.x() * by, direction.y() * by);
    }

    private void addMaking() {
        add(
                        "net-add-place",
                        "Add a place",
                        () -> actions.addBlank(Kind.PLACE, here().x(), here().y()),
                        open("net-add-place"),
                        "P")
                .withIcon("place");
        add(
                        "net-add-transition",
                        "Add a transition",
                        () -> actions.addBlank(Kind.TRANSITION, here().x(), here().y()),
                        open("net-add-transition"),
                        "T")
                .withIcon("transition");
        add(
                        "net-connect",
                        "Connect with…",
                        () -> connecting.begin(
                                actions.selectedVertex().orElseThrow().id()),
                        oneVertex("net-connect"),
                        "C")
                .withIcon("edge");
        add(
                "net-append",
                "What can come next…",
                () -> actions.selectedVertex().ifPresent(vertex -> {
                    var at = view.pixel(vertex.box().maxX(), vertex.centre().y());
                    actions.openAppendMenu(vertex.id(), (int) at.getX(), (int) at.getY());
                }),
                oneVertex("net-append"),
                "A",
                "INSERT");
        add("net-add-note", "Add a note", () -> actions.addNote(here()), open("net-add-note"), "N")
                .withIcon("note");
        add(
                "net-lay-notes",
                "Put the plan's notes on the net",
                actions::layNotes,
                () -> actions.whyNotEdit("net-lay-notes")
                        .or(() -> net.plan().notes().stream().anyMatch(n -> n.at().isEmpty())
                                ? Optional.empty()
                                : Optional.of("all notes lie on the net")));
    }

    private void addCopying() {
        add("net-copy", "Copy", actions::copy, vertices("net-copy", 1), "ctrl C");
        add(
                "net-cut",
                "Cut",
                () -> {
                    actions.copy();
                    actions.delete();
                },
                vertices("net-cut", 1),
                "ctrl X");
        add("net-paste", "Paste", () -> actions.paste(Optional.empty()), actions::whyNotPaste, "ctrl V");
        add(
                "net-paste-here",
                "Paste at the pointer",
                () -> actions.paste(tool.pointer()),
                actions::whyNotPaste,
                "ctrl shift V");
        add("net-duplicate", "Duplicate", actions::duplicate, vertices("net-duplicate", 1), "ctrl D");
    }

    private void addArranging() {
        String[] keys = {
            "alt shift LEFT",
            "alt shift C",
            "alt shift RIGHT",
            "alt shift UP",
            "alt shift R",
            "alt shift DOWN",
            "alt shift X",
            "alt shift Y"
        };
        int i = 0;
        for (Alignment alignment : Alignment.values()) {
            String id = "net-align-" + alignment.name().toLowerCase(Locale.ROOT).replace('_', '-');
            add(id, alignment.label(), () -> actions.align(alignment), vertices(id, alignment.least()), keys[i++]);
        }
        add(
                "net-snap",
                "Snap to the grid and to neighbours, or not",
                () -> {
                    tool.setSnapping(!tool.isSnapping());
                    actions.tell(tool.isSnapping() ? "What is dragged snaps" : "What is dragged does not snap");
                },
                Optional::empty,
                "G");
    }

    private void addMeaning() {
        add(
                "net-set-start",
                "Start here",
                () -> meaning((plan, id) -> new VertexEdit.SetStart(plan, id)),
                this::whyNotPlace);
        add(
                "net-set-end",
                "End here, or not",
                () -> meaning((plan, id) -> {
                    boolean end = net.plan().place(id).orElseThrow().end();
                    return new VertexEdit.SetEnd(plan, id, !end, false);
                }),
                this::whyNotPlace);
        add("net-mark-recovery", "Make it a recovery part", () -> mark(Mode.RECOVERY), selected("net-mark-recovery"));
        add("net-mark-nominal", "Make it a nominal part", () -> mark(Mode.NOMINAL), selected("net-mark-nominal"));
        add(
                "net-extract",
                "Extract to a sub-mission",
                this::extract,
                () -> actions.whyNotEdit("net-extract")
                        .or(() -> ExtractSubMission.whyNot(net.plan(), actions.selection())),
                "X");
        add(
                "net-recovery",
                "Nominal or recovery mode",
                () -> context.editor()
                        .setMode(context.editor().mode() == NetMode.RECOVERY ? NetMode.NOMINAL : NetMode.RECOVERY),
                Optional::empty,
                "R");
    }

    private void meaning(BiFunction<String, String, Edit> edit) {
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
