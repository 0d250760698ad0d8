package org.sami.dreamm.canvas;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.BooleanSupplier;
import org.sami.dreamm.context.DreammContext;
import org.sami.picture.NetFonts;
import org.sami.spn.drawing.NetDetail;
import org.sami.spn.drawing.NetDrawing;
import org.sami.spn.drawing.NetLayout;
import org.sami.spn.edit.Edit;
import org.sami.spn.edit.EditSequence;
import org.sami.spn.model.LayoutPoint;
import org.sami.spn.model.Plan;
import org.sami.spn.vocabulary.Vocabulary;
import org.sami.ui.canvas.CanvasKey;
import org.sami.ui.command.Command;
import org.sami.ui.net.GraphLayout;
import org.sami.ui.net.NetView;

/**
 * Lays the open plan out when the author asks for it: off the event thread, until it is cancelled, as one edit that can be undone. A plan
 * that was changed meanwhile stays as it is.
 */
final class LayoutCommands {
    private final DreammContext context;
    private final NetView view;
    private final ShownNet net;
    private final NetActions actions;
    private Optional<AtomicBoolean> underWay = Optional.empty();

    /** Computes centres of vertices, in drawing units. */
    private interface Layout {
        Map<String, LayoutPoint> of(Plan plan, NetDrawing drawing, BooleanSupplier cancelled);
    }

    LayoutCommands(DreammContext context, NetView view, ShownNet net, NetActions actions) {
        this.context = context;
        this.view = view;
        this.net = net;
        this.actions = actions;
    }

    void add() {
        Vocabulary vocabulary = context.vocabulary();
        add("net-layout-layers", "Lay out in layers from left to right", "L", (plan, drawing, cancelled) -> {
                    NetDetail detail =
                            net.detail().withRequirements(false); // on the lines there is room for them anyway
                    return centres(NetLayout.layered(plan, vocabulary, NetFonts::width, detail, cancelled));
                })
                .withIcon("layout");
        add("net-layout-forces", "Lay out by forces", "shift L", GraphLayout.FORCES::of);
        add("net-layout-distances", "Lay out by distances", "alt L", GraphLayout.DISTANCES::of);
        context.commands()
                .add(new Command("net-layout-cancel", "Cancel the layout", this::cancel)
                        .withKey("ctrl shift L")
                        .unless(() -> underWay.isPresent() ? Optional.empty() : Optional.of("no layout is under way")));
    }

    private Command add(String id, String title, String key, Layout layout) {
        Command command = context.commands()
                .add(new Command(id, title, () -> lay(title, layout))
                        .withFocusKeys(CanvasKey.strokes(key))
                        .unless(() -> whyNot(id)));
        command.bindTo(view.canvas());
        return command;
    }

    private Optional<String> whyNot(String id) {
        return actions.whyNotEdit(id)
                .or(() -> underWay.isPresent() ? Optional.of("a layout is under way") : Optional.empty())
                .or(() -> net.drawing().vertices().size() < 2
                        ? Optional.of("there is nothing to lay out")
                        : Optional.empty());
    }

    private static Map<String, LayoutPoint> centres(NetDrawing drawing) {
        Map<String, LayoutPoint> centres = new LinkedHashMap<>();
        drawing.vertices().forEach(vertex -> centres.put(vertex.id(), vertex.centre()));
        return centres;
    }

    private void lay(String title, Layout layout) {
        AtomicBoolean cancelled = new AtomicBoolean();
        underWay = Optional.of(cancelled);
        Plan plan = net.plan();
        NetDrawing drawing = net.drawing();
        actions.tell(title + ": under way, Escape cancels");
        context.commands().refresh();
        context.background()
                .run(
                        title,
                        () -> {
                            try {
                                return layout.of(plan, drawing, cancelled::get);
                            } catch (CancellationException e) {
                                return Map.<String, LayoutPoint>of();
                            }
                        },
                        centres -> {
                            underWay = Optional.empty();
                            done(title, plan, drawing, cancelled.get() ? Map.of() : centres);
                            context.commands().refresh();
                        });
    }

    private void done(String title, Plan plan, NetDrawing drawing, Map<String, LayoutPoint> centres) {
        if (centres.isEmpty()) {
            actions.tell(title + ": cancelled, nothing was moved");
        } else if (!plan.equals(net.plan())) {
            actions.refuse("The plan was changed while it was laid out: nothing was moved");
        } else {
            double dx = left(centres(drawing), true) - left(centres, true);
            double dy = left(centres(drawing), false) - left(centres, false);
            Map<String, LayoutPoint> moved = new LinkedHashMap<>();
            centres.forEach((id, at) -> moved.put(id, new LayoutPoint(at.x() + dx, at.y() + dy)));
            List<Edit> edits = new ArrayList<>(List.of(actions.edits().moveTo(moved)));
            edits.addAll(actions.edits().frames().following(moved));
            if (actions.apply(new EditSequence(title, edits))) {
                view.fit();
            }
        }
    }

    private static double left(Map<String, LayoutPoint> centres, boolean x) {
        return centres.values().stream()
                .mapToDouble(at -> x ? at.x() : at.y())
                .min()
                .orElse(0);
    }

    /** Cancels the layout that is under way; says whether one was. */
    boolean cancel() {
        underWay.ifPresent(cancelled -> cancelled.set(true));
        return underWay.isPresent();
    }
}
