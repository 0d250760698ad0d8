package org.sami.dreamm.learn.view;

import java.awt.Component;
import java.awt.Container;
import java.awt.Dimension;
import java.awt.Insets;
import java.awt.LayoutManager;
import org.sami.ui.look.Look;

/** Lays a mark, such as a button, at the left of a text, which has the rest of the width and wraps. */
final class LeadLayout implements LayoutManager {
    private final int gap;

    /**
     * A row of two components.
     *
     * @param gap between them, in logical pixels
     */
    LeadLayout(int gap) {
        this.gap = gap;
    }

    @Override
    public Dimension preferredLayoutSize(Container parent) {
        Insets insets = parent.getInsets();
        Dimension lead = parent.getComponent(0).getPreferredSize();
        int height = Math.max(lead.height, ColumnLayout.heightOf(parent.getComponent(1), rest(parent)));
        return new Dimension(parent.getWidth(), height + insets.top + insets.bottom);
    }

    private int rest(Container parent) {
        Insets insets = parent.getInsets();
        Dimension lead = parent.getComponent(0).getPreferredSize();
        return Math.max(1, parent.getWidth() - insets.left - insets.right - lead.width - Look.px(gap));
    }

    @Override
    public Dimension minimumLayoutSize(Container parent) {
        return new Dimension(0, preferredLayoutSize(parent).height);
    }

    @Override
    public void layoutContainer(Container parent) {
        Insets insets = parent.getInsets();
        Component lead = parent.getComponent(0);
        Component text = parent.getComponent(1);
        Dimension size = lead.getPreferredSize();
        int height = ColumnLayout.heightOf(text, rest(parent));
        lead.setBounds(insets.left, insets.top, size.width, size.height);
        int below = Math.max(0, (size.height - height) / 2);
        text.setBounds(insets.left + size.width + Look.px(gap), insets.top + below, rest(parent), height);
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
