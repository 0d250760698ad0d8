package org.sami.dreamm.canvas;

import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.function.BooleanSupplier;
import org.sami.dreamm.context.DreammContext;
import org.sami.spn.drawing.NetDrawing.Kind;
import org.sami.spn.model.LayoutPoint;
import org.sami.ui.net.NetView;

/** The commands that select, make, copy and arrange elements of the net; those that walk along edges, and those that change what elements are, are added along with them. */
final class CanvasCommands {
    private final DreammContext context;
    private final NetView view;
    private final ShownNet net;
    private final NetActions actions;
    private final EditTool tool;
    private final Connecting connecting;
    private final BooleanSupplier cancelLayout;
    private final NetCommands commands;

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
        commands = new NetCommands(context, view, actions);
    }

    void add() {
        addSelecting();
        new WalkCommands(context, view, net, actions, commands, connecting).add();
        addMaking();
        addCopying();
        addArranging();
        new ElementRoleCommands(context, net, actions, commands).add();
    }

    private LayoutPoint here() {
        return tool.pointer().orElseGet(view::centre);
    }

    private void addSelecting() {
        commands.add("net-select-all", "Select all", actions::selectAll, commands.open("net-select-all"), "ctrl A");
        commands.add("net-clear", "Select nothing", this::leave, Optional::empty, "ESCAPE");
        commands.add("net-delete", "Delete", actions::delete, commands.selected("net-delete"), "DELETE", "BACK_SPACE")
                .withIcon("clear");
        commands.add("net-rename", "Write the name or the note", actions::rename, this::whyNotWrite, "F2")
                .withIcon("edit");
        commands.add("net-open", "Open what is behind it", this::open, commands.selected("net-open"), "ENTER");
    }

    private Optional<String> whyNotWrite() {
        return actions.whyNotEdit("net-rename")
                .or(() -> actions.selectedVertex().isPresent()
                                || !actions.edits().notes(actions.selection()).isEmpty()
                                || !actions.edits()
                                        .frames()
                                        .frames(actions.selection())
                                        .isEmpty()
                        ? Optional.empty()
                        : Optional.of("select one vertex, a note or a frame"));
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

    private void addMaking() {
        commands.add(
                        "net-add-place",
                        "Add a place",
                        () -> actions.addBlank(Kind.PLACE, here().x(), here().y()),
                        commands.open("net-add-place"),
                        "P")
                .withIcon("place");
        commands.add(
                        "net-add-transition",
                        "Add a transition",
                        () -> actions.addBlank(Kind.TRANSITION, here().x(), here().y()),
                        commands.open("net-add-transition"),
                        "T")
                .withIcon("transition");
        commands.add(
                        "net-connect",
                        "Connect with…",
                        () -> connecting.begin(
                                actions.selectedVertex().orElseThrow().id()),
                        commands.oneVertex("net-connect"),
                        "C")
                .withIcon("edge");
        commands.add(
                "net-append",
                "What can come next…",
                () -> actions.selectedVertex().ifPresent(vertex -> {
                    var at = view.pixel(vertex.box().maxX(), vertex.centre().y());
                    actions.openAppendMenu(vertex.id(), (int) at.getX(), (int) at.getY());
                }),
                commands.oneVertex("net-append"),
                "A",
                "INSERT");
        commands.add("net-add-note", "Add a note", () -> actions.addNote(here()), commands.open("net-add-note"), "N")
                .withIcon("note");
        commands.add(
                        "net-add-frame",
                        "Put a frame around the selection",
                        () -> actions.addFrame(here()),
                        commands.open("net-add-frame"),
                        "ctrl G")
                .withIcon("frame");
        commands.add(
                "net-lay-notes",
                "Put the plan's notes on the net",
                actions::layNotes,
                () -> actions.whyNotEdit("net-lay-notes")
                        .or(() -> net.plan().notes().stream().anyMatch(n -> n.at().isEmpty())
                                ? Optional.empty()
                                : Optional.of("all notes lie on the net")));
    }

    private void addCopying() {
        commands.add("net-copy", "Copy", actions::copy, commands.vertices("net-copy", 1), "ctrl C");
        commands.add(
                "net-cut",
                "Cut",
                () -> {
                    actions.copy();
                    actions.delete();
                },
                commands.vertices("net-cut", 1),
                "ctrl X");
        commands.add("net-paste", "Paste", () -> actions.paste(Optional.empty()), actions::whyNotPaste, "ctrl V");
        commands.add(
                "net-paste-here",
                "Paste at the pointer",
                () -> actions.paste(tool.pointer()),
                actions::whyNotPaste,
                "ctrl shift V");
        commands.add("net-duplicate", "Duplicate", actions::duplicate, commands.vertices("net-duplicate", 1), "ctrl D");
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
            commands.add(
                    id,
                    alignment.label(),
                    () -> actions.align(alignment),
                    commands.vertices(id, alignment.least()),
                    keys[i++]);
        }
        commands.add(
                "net-snap",
                "Snap to the grid and to neighbours, or not",
                () -> {
                    tool.setSnapping(!tool.isSnapping());
                    actions.tell(tool.isSnapping() ? "What is dragged snaps" : "What is dragged does not snap");
                },
                Optional::empty,
                "G");
    }
}
