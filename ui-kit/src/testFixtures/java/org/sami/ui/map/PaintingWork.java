package org.sami.ui.map;

import java.awt.Component;
import java.awt.Graphics2D;
import java.awt.Shape;
import java.awt.geom.PathIterator;
import java.awt.image.BufferedImage;
import java.util.LinkedHashSet;
import java.util.Set;

/**
 * What a component paints: the texts, and how much it is, counted and not timed: segments of shapes, letters, images. What an event thread paints within 100 ms on a slow
 * machine is some ten thousand of them.
 */
public final class PaintingWork {
    private final Set<String> texts = new LinkedHashSet<>();
    private long count;

    private PaintingWork() {}

    /** Paints a component that was laid out, and counts. */
    public static long of(Component component) {
        return paint(component).count;
    }

    /** Paints a component that was laid out; the texts that are painted, as they are cut where there is no room. */
    public static Set<String> textsOf(Component component) {
        return paint(component).texts;
    }

    private static PaintingWork paint(Component component) {
        PaintingWork work = new PaintingWork();
        BufferedImage image =
                new BufferedImage(component.getWidth(), component.getHeight(), BufferedImage.TYPE_INT_RGB);
        Graphics2D g = new CountingGraphics(image.createGraphics(), work);
        component.printAll(g); // without an image between, which would hide what is painted into it
        g.dispose();
        return work;
    }

    void text(String text) {
        texts.add(text);
        count += text.length();
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
