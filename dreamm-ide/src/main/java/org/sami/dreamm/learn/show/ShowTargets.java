package org.sami.dreamm.learn.show;

import java.awt.Component;
import java.awt.Container;
import java.awt.Rectangle;
import java.awt.geom.Point2D;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Predicate;
import javax.swing.JComponent;
import javax.swing.JList;
import javax.swing.JRootPane;
import javax.swing.JTextField;
import javax.swing.ListModel;
import javax.swing.SwingUtilities;
import org.sami.dreamm.context.DreammContext;
import org.sami.dreamm.palette.PaletteItem;
import org.sami.spn.drawing.DrawingBox;
import org.sami.spn.drawing.NetDrawing;
import org.sami.spn.drawing.NetDrawing.Edge;
import org.sami.spn.drawing.NetDrawing.Vertex;
import org.sami.spn.model.LayoutPoint;
import org.sami.ui.command.Command;
import org.sami.ui.net.NetView;

/** Finds in a window where the stops of a pointer are, and brings them into sight. On the event thread. */
final class ShowTargets {
    private static final double SPOT = 24;

    private final DreammContext context;
    private final JRootPane root;

    ShowTargets(DreammContext context, JRootPane root) {
        this.context = context;
        this.root = root;
    }

    /** The view of the net; empty where it is not shown. */
    Optional<NetView> net() {
        return find(root.getContentPane(), c -> c instanceof NetView && isIn("model-view", c))
                .map(NetView.class::cast);
    }

    private static boolean isIn(String name, Component c) {
        for (Component up = c; up != null; up = up.getParent()) {
            if (name.equals(up.getName())) {
                return true;
            }
        }
        return false;
    }

    /** Opens the panel in which a stop is, selects what it is about, and scrolls to it. */
    void prepare(ShowStop stop) {
        if (stop instanceof ShowStop.Item item) {
            open("panel-palette");
            paletteSearch().filter(field -> !field.getText().isEmpty()).ifPresent(field -> field.setText(""));
            palette().ifPresent(list -> {
                int row = row(list, item.id());
                list.setSelectedIndex(row);
                list.ensureIndexIsVisible(row);
            });
        } else if (stop instanceof ShowStop.Element element) {
            context.editor().select(List.of(element.id()));
            net().ifPresent(net -> net.reveal(Set.of(element.id())));
        } else if (stop instanceof ShowStop.Editor editor) {
            context.editor().select(editor.selected());
            open("panel-inspector");
            root.validate();
            editor(editor).ifPresent(c -> c.scrollRectToVisible(new Rectangle(0, 0, c.getWidth(), c.getHeight())));
        }
    }

    private void open(String panel) {
        context.commands().find(panel).filter(command -> !command.isHidden()).ifPresent(Command::run);
    }

    /** Where a stop is, in a component's pixels; empty where it is not to be seen. */
    Optional<Rectangle> of(ShowStop stop, JComponent over) {
        if (stop instanceof ShowStop.Item item) {
            return palette().flatMap(list -> cell(list, row(list, item.id()), over));
        }
        if (stop instanceof ShowStop.Element element) {
            return net().flatMap(net -> box(net, element.id()).map(box -> pixels(net, box, over)));
        }
        if (stop instanceof ShowStop.Spot spot) {
            return net().map(net -> pixels(net, around(spot.at(), net.drawing().scale()), over));
        }
        return editor((ShowStop.Editor) stop).map(c -> seen(c, new Rectangle(0, 0, c.getWidth(), c.getHeight()), over));
    }

    private static Rectangle seen(JComponent c, Rectangle part, JComponent over) {
        Rectangle visible = part.intersection(c.getVisibleRect());
        return SwingUtilities.convertRectangle(c, visible.isEmpty() ? part : visible, over);
    }

    private static DrawingBox around(LayoutPoint at, double scale) {
        return new DrawingBox(at.x() * scale - SPOT, at.y() * scale - SPOT, 2 * SPOT, 2 * SPOT);
    }

    private static Optional<DrawingBox> box(NetView net, String id) {
        NetDrawing drawing = net.drawing();
        return drawing.vertices().stream()
                .filter(v -> v.id().equals(id))
                .map(Vertex::box)
                .findFirst()
                .or(() -> drawing.edges().stream()
                        .filter(e -> e.id().equals(id))
                        .map(ShowTargets::middle)
                        .findFirst());
    }

    private static DrawingBox middle(Edge edge) {
        LayoutPoint a = edge.points().get((edge.points().size() - 1) / 2);
        LayoutPoint b = edge.points().get(edge.points().size() / 2);
        return around(new LayoutPoint((a.x() + b.x()) / 2, (a.y() + b.y()) / 2), 1);
    }

    private static Rectangle pixels(NetView net, DrawingBox box, JComponent over) {
        Point2D from = net.pixel(box.x(), box.y());
        Point2D to = net.pixel(box.x() + box.width(), box.y() + box.height());
        Rectangle there = new Rectangle(
                (int) from.getX(), (int) from.getY(), (int) (to.getX() - from.getX()), (int) (to.getY() - from.getY()));
        return SwingUtilities.convertRectangle(net.canvas(), there, over);
    }

    private Optional<JTextField> paletteSearch() {
        return find(root.getContentPane(), c -> c instanceof JTextField && "palette-search".equals(c.getName()))
                .map(JTextField.class::cast);
    }

    private Optional<JList<?>> palette() {
        return find(root.getContentPane(), c -> c instanceof JList<?> && "palette-list".equals(c.getName()))
                .filter(Component::isShowing)
                .map(c -> (JList<?>) c);
    }

    private static int row(JList<?> list, String item) {
        ListModel<?> rows = list.getModel();
        for (int i = 0; i < rows.getSize(); i++) {
            if (rows.getElementAt(i) instanceof PaletteItem there && there.id().equals(item)) {
                return i;
            }
        }
        return -1;
    }

    private static Optional<Rectangle> cell(JList<?> list, int row, JComponent over) {
        return Optional.ofNullable(row < 0 ? null : list.getCellBounds(row, row))
                .map(cell -> seen(list, cell, over));
    }

    /** The component of a stop; the part around it where that is not there; empty where the inspector is not shown. */
    private Optional<JComponent> editor(ShowStop.Editor stop) {
        Optional<Component> inspector = find(root.getContentPane(), c -> "inspector-panel".equals(c.getName()))
                .filter(Component::isShowing);
        Optional<Component> part = stop.within().isEmpty()
                ? inspector
                : inspector.flatMap(panel -> find(panel, c -> stop.within().equals(c.getName())));
        return part.flatMap(inside -> find(inside, c -> stop.name().equals(c.getName())))
                .or(() -> part)
                .or(() -> inspector)
                .filter(JComponent.class::isInstance)
                .map(JComponent.class::cast);
    }

    private static Optional<Component> find(Component in, Predicate<Component> which) {
        if (which.test(in)) {
            return Optional.of(in);
        }
        if (in instanceof Container container) {
            for (Component child : container.getComponents()) {
                Optional<Component> found = find(child, which);
                if (found.isPresent()) {
                    return found;
                }
            }
        }
        return Optional.empty();
    }
}
