package org.sami.ui.map;

import java.awt.Cursor;
import java.util.function.Supplier;
import org.sami.spn.value.GeoPoint;
import org.sami.ui.geo.GeoSketch;
import org.sami.ui.geo.MapFrame;

/**
 * Draws and changes a sketch: a click puts a point, a corner can be dragged, the middle of a line is dragged to become a corner, a
 * right click takes a corner away; a double click or Enter ends it, Escape leaves it. A box with Shift held chooses, as ever.
 */
final class SketchTool implements MapTool {
    private static final double REACH_PX = 11;
    private static final double STEP_PX = 1;

    private final GeoSketch sketch;
    private final Supplier<MapFrame> map;
    private final SketchPainter painter;
    private final MapTool boxes;
    private final Runnable finished;
    private final Runnable cancelled;
    private int dragged = -1;
    private boolean boxing;

    /**
     * Makes a tool for one sketch.
     *
     * @param boxes does what is done with Shift held
     * @param map which part of the world is shown
     * @param measuring whether lengths are written at all lines, and not only the total
     */
    SketchTool(
            GeoSketch sketch,
            boolean measuring,
            MapTool boxes,
            Supplier<MapFrame> map,
            Runnable finished,
            Runnable cancelled) {
        this.sketch = sketch;
        this.boxes = boxes;
        this.map = map;
        this.painter = new SketchPainter(sketch, measuring);
        this.finished = finished;
        this.cancelled = cancelled;
    }

    GeoSketch sketch() {
        return sketch;
    }

    @Override
    public boolean press(MapPointer pointer) {
        if (pointer.menu()) {
            return false;
        }
        boxing = pointer.box() && boxes.press(pointer);
        if (boxing) {
            return true;
        }
        int corner = cornerAt(pointer);
        int middle = corner >= 0 ? -1 : middleAt(pointer);
        if (corner < 0 && middle < 0) {
            return false;
        }
        sketch.beginMove();
        if (middle >= 0) {
            sketch.insert(middle, pointer.at());
        }
        dragged = Math.max(corner, middle);
        sketch.select(dragged);
        return true;
    }

    @Override
    public void drag(MapPointer pointer) {
        if (boxing) {
            boxes.drag(pointer);
        } else {
            sketch.move(dragged, pointer.at());
        }
    }

    @Override
    public void release(MapPointer pointer) {
        if (boxing) {
            boxing = false;
            boxes.release(pointer);
            return;
        }
        sketch.endMove();
        dragged = -1;
        if (pointer.clicks() == 2) {
            finished.run();
        }
    }

    @Override
    public void click(MapPointer pointer) {
        int corner = cornerAt(pointer);
        if (pointer.menu()) {
            if (corner >= 0) {
                sketch.remove(corner);
            }
        } else if (pointer.clicks() == 2) {
            finished.run();
        } else {
            sketch.add(pointer.at());
        }
    }

    @Override
    public void move(MapPointer pointer) {
        painter.pointTo(pointer);
    }

    private int cornerAt(MapPointer pointer) {
        int nearest = -1;
        double least = Painting.px(REACH_PX);
        for (int i = 0; i < sketch.points().size(); i++) {
            double distance = pointer.frame().distancePx(sketch.points().get(i), pointer.px(), pointer.py());
            if (distance <= least) {
                nearest = i;
                least = distance;
            }
        }
        return nearest;
    }

    /** The index of the corner that the middle of a line would become. */
    private int middleAt(MapPointer pointer) {
        MapFrame frame = pointer.frame();
        for (int i = 1; i < painter.ring().size(); i++) {
            GeoPoint middle = SketchPainter.middle(
                    frame, painter.ring().get(i - 1), painter.ring().get(i));
            if (painter.hasMiddle(frame, i)
                    && frame.distancePx(middle, pointer.px(), pointer.py()) <= Painting.px(REACH_PX)) {
                return i;
            }
        }
        return -1;
    }

    @Override
    public boolean key(MapKey key) {
        int chosen = sketch.selected().orElse(-1);
        int count = sketch.points().size();
        switch (key) {
            case NEXT -> sketch.select(count == 0 ? -1 : (chosen + 1) % count);
            case PREVIOUS -> sketch.select(count == 0 ? -1 : (Math.max(chosen, 0) + count - 1) % count);
            case DELETE -> {
                if (count > 0) {
                    sketch.remove(chosen >= 0 ? chosen : count - 1);
                }
            }
            case UNDO -> sketch.undo();
            case REDO -> sketch.redo();
            case FINISH -> finished.run();
            case CANCEL -> cancelled.run();
            case ADD -> painter.pointedTo().ifPresent(sketch::add);
            case LEFT -> {
                return nudge(chosen, -STEP_PX, 0);
            }
            case RIGHT -> {
                return nudge(chosen, STEP_PX, 0);
            }
            case UP -> {
                return nudge(chosen, 0, -STEP_PX);
            }
            case DOWN -> {
                return nudge(chosen, 0, STEP_PX);
            }
            default -> {
                return false;
            }
        }
        return key != MapKey.ADD || painter.pointedTo().isPresent();
    }

    private boolean nudge(int chosen, double dx, double dy) {
        if (chosen < 0) {
            return false;
        }
        MapFrame frame = map.get();
        GeoPoint at = sketch.points().get(chosen);
        sketch.move(chosen, frame.point(frame.px(at) + dx, frame.py(at) + dy));
        return true;
    }

    @Override
    public void paint(MapPaint paint) {
        painter.paint(paint);
        if (boxing) {
            boxes.paint(paint);
        }
    }

    @Override
    public void paintNames(MapPaint paint) {
        painter.paintNames(paint);
    }

    @Override
    public Cursor cursor() {
        return Cursor.getPredefinedCursor(Cursor.CROSSHAIR_CURSOR);
    }

    @Override
    public boolean snaps() {
        return true;
    }
}
