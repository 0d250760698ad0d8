package org.sami.ui.map;

import java.awt.Component;
import java.awt.Graphics2D;
import java.awt.Shape;
import java.awt.geom.PathIterator;
import java.awt.image.BufferedImage;

/**
 * How much a component paints, counted and not timed: segments of shapes, letters, images. What an event thread paints within 100 ms on a slow
 * machine is some ten thousand of them.
 */
public final class PaintingWork {
    private long count;

    private PaintingWork() {}

    /** Paints a component that was laid out, and counts. */
    public static long of(Component component) {
        PaintingWork work = new PaintingWork();
        BufferedImage image =
                new BufferedImage(component.getWidth(), component.getHeight(), BufferedImage.TYPE_INT_RGB);
        Graphics2D g = new CountingGraphics(image.createGraphics(), work);
        component.paint(g);
        g.dispose();
        return work.count;
    }

    void add(long some) {
        count += some;
    }

    void shape(Shape shape) {
        for (PathIterator path = shape.getPathIterator(null); !path.isDone(); path.next()) {
            count++;
        }
    }
}
