package org.sami.ui.net;

import java.awt.BasicStroke;
import java.awt.Graphics2D;
import java.awt.geom.Rectangle2D;
import java.util.LinkedHashSet;
import java.util.Optional;
import java.util.Set;
import org.sami.palette.SemanticColor;

/** Selects by clicks, with Ctrl one more, with Shift all in a box; a double click opens. */
final class NetSelectTool implements NetTool {
    private final NetView view;
    private Optional<Rectangle2D> box = Optional.empty();
    private double fromX;
    private double fromY;

    NetSelectTool(NetView view) {
        this.view = view;
    }

    @Override
    public boolean press(NetPointer pointer) {
        if (!pointer.box() || pointer.menu()) {
            return false;
        }
        fromX = pointer.x();
        fromY = pointer.y();
        box = Optional.of(new Rectangle2D.Double(fromX, fromY, 0, 0));
        return true;
    }

    @Override
    public void drag(NetPointer pointer) {
        box.ifPresent(each -> each.setFrameFromDiagonal(fromX, fromY, pointer.x(), pointer.y()));
        view.repaint();
    }

    @Override
    public void release(NetPointer pointer) {
        Set<String> inside = new LinkedHashSet<>();
        box.ifPresent(each -> view.scene().vertices().stream()
                .filter(vertex ->
                        each.contains(vertex.centre().x(), vertex.centre().y()))
                .forEach(vertex -> inside.add(vertex.id())));
        box = Optional.empty();
        view.select(inside);
    }

    @Override
    public void click(NetPointer pointer) {
        Optional<String> element = pointer.element();
        if (!pointer.menu() || element.filter(view.selected()::contains).isEmpty()) {
            Set<String> selected = new LinkedHashSet<>(pointer.additive() ? view.selected() : Set.of());
            element.filter(id -> !selected.remove(id)).ifPresent(selected::add);
            view.select(selected);
        }
        if (pointer.menu()) {
            view.tellMenu(element.orElse(""), pointer.px(), pointer.py());
        } else if (pointer.clicks() == 2) {
            element.ifPresent(view::tellOpened);
        }
    }

    @Override
    public void paint(Graphics2D g) {
        box.ifPresent(each -> {
            g.setColor(SemanticColor.ACCENT.withAlpha(40));
            g.fill(each);
            g.setColor(SemanticColor.ACCENT.get());
            g.setStroke(new BasicStroke(1.5f));
            g.draw(each);
        });
    }
}
