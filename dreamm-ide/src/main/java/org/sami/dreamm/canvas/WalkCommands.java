package org.sami.dreamm.canvas;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import org.sami.dreamm.context.DreammContext;
import org.sami.spn.drawing.NetDrawing.Vertex;
import org.sami.ui.net.NetView;

/** The commands that go along the net by keys, and move what is selected there. */
final class WalkCommands {
    private final DreammContext context;
    private final NetView view;
    private final ShownNet net;
    private final NetActions actions;
    private final NetCommands commands;
    private final Connecting connecting;

    WalkCommands(
            DreammContext context,
            NetView view,
            ShownNet net,
            NetActions actions,
            NetCommands commands,
            Connecting connecting) {
        this.context = context;
        this.view = view;
        this.net = net;
        this.actions = actions;
        this.commands = commands;
        this.connecting = connecting;
    }

    void add() {
        for (NetWalk.Direction direction : NetWalk.Direction.values()) {
            String key = direction.name();
            String way = key.toLowerCase(Locale.ROOT);
            commands.add(
                    "net-walk-" + way,
                    "Go " + way + " along the net",
                    () -> walk(direction),
                    commands.open("net-walk"),
                    key);
            commands.add(
                    "net-extend-" + way,
                    "Select the vertex " + way + ", too",
                    () -> extend(direction),
                    commands.open("net-walk"),
                    "shift " + key);
            commands.add(
                    "net-nudge-" + way,
                    "Move " + way + " by a step of the grid",
                    () -> nudge(direction, SnapWhileDragging.GRID),
                    commands.selected("net-move"),
                    "ctrl " + key);
            commands.add(
                    "net-nudge-fine-" + way,
                    "Move " + way + " a little",
                    () -> nudge(direction, 2),
                    commands.selected("net-move"),
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
}
