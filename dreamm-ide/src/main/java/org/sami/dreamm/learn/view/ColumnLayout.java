package org.sami.dreamm.learn.view;

import java.awt.Component;
import java.awt.Container;
import java.awt.Dimension;
import java.awt.Insets;
import java.awt.LayoutManager;
import javax.swing.JViewport;
import org.sami.ui.look.Look;

/**
 * Lays components below each other, each as wide as the column and as high as it needs to be at that width: texts that wrap and pictures that shrink
 * say their height only after they have a width.
 */
final class ColumnLayout implements LayoutManager {
    private static final int UNBOUNDED = 100_000; // more pixels than any screen has, at each scale

    private final int gap;
    private final int widest;

    /**
     * A column that has all of the width.
     *
     * @param gap between two components, in logical pixels
     */
    ColumnLayout(int gap) {
        this(gap, UNBOUNDED);
    }

    /**
     * A column in the middle of the width.
     *
     * @param gap between two components, in logical pixels
     * @param widest how wide it is at most, in logical pixels: long lines are hard to read
     */
    ColumnLayout(int gap, int widest) {
        this.gap = gap;
        this.widest = widest;
    }

    private int inner(int width, Insets insets) {
        return Math.max(1, Math.min(width - insets.left - insets.right, Look.px(widest)));
    }

    @Override
    public Dimension preferredLayoutSize(Container parent) {
        Insets insets = parent.getInsets();
        int width = parent.getParent() instanceof JViewport port && port.getWidth() > 0
                ? port.getWidth()
                : parent.getWidth();
        int height = insets.top + insets.bottom;
        boolean first = true;
        for (Component each : parent.getComponents()) {
            if (each.isVisible()) {
                height += heightOf(each, inner(width, insets)) + (first ? 0 : Look.px(gap));
                first = false;
            }
        }
        return new Dimension(width, height);
    }

    @Override
    public Dimension minimumLayoutSize(Container parent) {
        return new Dimension(0, preferredLayoutSize(parent).height);
    }

    @Override
    public void layoutContainer(Container parent) {
        Insets insets = parent.getInsets();
        int width = inner(parent.getWidth(), insets);
        int x = insets.left + Math.max(0, (parent.getWidth() - insets.left - insets.right - width) / 2);
        int y = insets.top;
        for (Component each : parent.getComponents()) {
            if (each.isVisible()) {
                int height = heightOf(each, width);
                each.setBounds(x, y, width, height);
                y += height + Look.px(gap);
            }
        }
    }

    /** How high a component is at a width. */
    static int heightOf(Component component, int width) {
        if (component.getWidth() != width || component.getHeight() == 0) {
            component.setSize(Math.max(1, width), Math.max(1, component.getHeight()));
        }
        return component.getPreferredSize().height;
    }

    @Override
    public void addLayoutComponent(String name, Component component) {
        // components need nothing of their own
    }

    @Override
    public void removeLayoutComponent(Component component) {
        // nor when they go
    }
}
