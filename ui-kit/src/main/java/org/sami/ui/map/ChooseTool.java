package org.sami.ui.map;

import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import org.sami.palette.SemanticColor;
import org.sami.ui.geo.MapFrame;

/** What the pointer does while nothing is drawn: clicks choose, a box with Shift held chooses all in it. */
final class ChooseTool implements MapTool {
    private final MapLayers layers;
    private final Consumer<MapClick> clicks;
    private final Consumer<List<String>> boxes;
    private final Runnable repaint;
    private Optional<MapPointer> from = Optional.empty();
    private Rectangle2D box = new Rectangle2D.Double();

    ChooseTool(MapLayers layers, Consumer<MapClick> clicks, Consumer<List<String>> boxes, Runnable repaint) {
        this.layers = layers;
        this.clicks = clicks;
        this.boxes = boxes;
        this.repaint = repaint;
    }

    @Override
    public boolean press(MapPointer pointer) {
        if (pointer.box() && !pointer.menu()) {
            from = Optional.of(pointer);
            box = new Rectangle2D.Double(pointer.px(), pointer.py(), 0, 0);
        }
        return from.isPresent();
    }

    @Override
    public void drag(MapPointer pointer) {
        from.ifPresent(start -> {
            box.setFrameFromDiagonal(start.px(), start.py(), pointer.px(), pointer.py());
            repaint.run();
        });
    }

    @Override
    public void release(MapPointer pointer) {
        from = Optional.empty();
        MapFrame frame = pointer.frame();
        List<String> items = new ArrayList<>();
        for (MapLayer layer : layers.visible()) {
            if (layer instanceof VehicleLayer vehicles) {
                vehicles.vehicles().stream()
                        .filter(vehicle -> box.contains(frame.px(vehicle.at()), frame.py(vehicle.at())))
                        .forEach(vehicle -> items.add(vehicle.id()));
            }
        }
        boxes.accept(items);
        repaint.run();
    }

    @Override
    public void click(MapPointer pointer) {
        clicks.accept(new MapClick(
                pointer.at(),
                layers.itemAt(pointer.frame(), pointer.px(), pointer.py()),
                (int) pointer.px(),
                (int) pointer.py(),
                pointer.additive(),
                pointer.menu(),
                pointer.clicks() == 2));
    }

    @Override
    public void paint(MapPaint paint) {
        if (from.isPresent()) {
            paint.g().setColor(SemanticColor.ACCENT.withAlpha(40));
            paint.g().fill(box);
            paint.g().setColor(SemanticColor.ACCENT.get());
            paint.g().setStroke(Painting.line(1.5));
            paint.g().draw(box);
        }
    }
}
