package org.sami.ui.dock;

import com.formdev.flatlaf.FlatClientProperties;
import com.formdev.flatlaf.util.UIScale;
import java.awt.Component;
import java.awt.FontMetrics;
import java.awt.Insets;
import java.awt.event.ComponentAdapter;
import java.awt.event.ComponentEvent;
import java.awt.event.ContainerAdapter;
import java.awt.event.ContainerEvent;
import java.util.Objects;
import javax.swing.JTabbedPane;
import javax.swing.UIManager;
import org.jspecify.annotations.Nullable;

/**
 * Keeps all tabs of a pane in sight: where they have no room with their words, those behind the front one are their icons, whose tooltips are
 * the words. Else the last ones are found only behind an arrow. On the event thread.
 */
final class TabWidths {
    private final JTabbedPane tabs;

    private TabWidths(JTabbedPane tabs) {
        this.tabs = tabs;
    }

    /** Keeps the tabs of all panes below a component in sight, and those of panes that are added to it later. */
    static void keep(Component component) {
        ComponentWatch.on(component, found -> {
            if (found instanceof JTabbedPane tabs) {
                new TabWidths(tabs).install();
            }
        });
    }

    private void install() {
        tabs.addComponentListener(new ComponentAdapter() {
            @Override
            public void componentResized(ComponentEvent resized) {
                fit();
            }
        });
        tabs.addChangeListener(change -> fit());
        tabs.addPropertyChangeListener("UI", change -> fit());
        tabs.addPropertyChangeListener("indexForTitle", change -> fit());
        tabs.addContainerListener(new ContainerAdapter() {
            @Override
            public void componentAdded(ContainerEvent added) {
                fit();
            }

            @Override
            public void componentRemoved(ContainerEvent removed) {
                fit();
            }
        });
        fit();
    }

    private void fit() {
        boolean brief = tabs.getWidth() > 0 && widthWithWords() > tabs.getWidth();
        put(
                FlatClientProperties.TABBED_PANE_TAB_WIDTH_MODE,
                brief ? FlatClientProperties.TABBED_PANE_TAB_WIDTH_MODE_COMPACT : null);
        put(FlatClientProperties.TABBED_PANE_MINIMUM_TAB_WIDTH, brief ? 0 : null);
    }

    private void put(String property, @Nullable Object value) {
        if (!Objects.equals(tabs.getClientProperty(property), value)) {
            tabs.putClientProperty(property, value);
        }
    }

    private int widthWithWords() {
        FontMetrics metrics = tabs.getFontMetrics(tabs.getFont());
        Insets insets = UIManager.getInsets("TabbedPane.tabInsets");
        int beside = UIScale.scale(insets.left + insets.right + UIManager.getInt("TabbedPane.textIconGap"));
        int least = UIScale.scale(UIManager.getInt("TabbedPane.minimumTabWidth"));
        int width = 0;
        for (int i = 0; i < tabs.getTabCount(); i++) {
            int icon = tabs.getIconAt(i) == null ? 0 : tabs.getIconAt(i).getIconWidth();
            width += Math.max(least, metrics.stringWidth(tabs.getTitleAt(i)) + icon + beside);
        }
        return width;
    }
}
