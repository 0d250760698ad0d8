package org.sami.ui.dock;

import java.awt.BorderLayout;
import java.awt.Dimension;
import java.awt.Rectangle;
import java.awt.event.ActionEvent;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import javax.swing.AbstractAction;
import javax.swing.BorderFactory;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JToggleButton;
import javax.swing.KeyStroke;
import net.miginfocom.swing.MigLayout;
import org.sami.ui.look.Fonts;
import org.sami.ui.look.Icons;
import org.sami.ui.look.Look;
import org.sami.ui.look.LookColors;
import org.sami.ui.look.SemanticColor;

/**
 * Panels folded to the right edge while one of them has all the room: a strip with a button for each, and the one that is open lies over the edge
 * of the large one, which keeps its size. On the event thread.
 */
final class FoldedPanels {
    private static final int WIDTH = 400;
    private static final double MOST = 0.6; // of the area's width

    private final JComponent area;
    private final Function<DockPanel, String> keyOf;
    private final Runnable focusLarge;
    private final JPanel strip = new JPanel(new MigLayout("novisualpadding, insets 4, gap 4, wrap 1", "[]", "[]"));
    private final JPanel open = new JPanel(new BorderLayout());
    private final JLabel title = new JLabel();
    private final List<JToggleButton> buttons = new ArrayList<>();
    private final List<DockPanel> panels = new ArrayList<>();
    private Optional<DockPanel> shown = Optional.empty();

    /**
     * Folded panels of an area.
     *
     * @param area which lays them out
     * @param unfold puts all panels back
     * @param focusLarge gives the focus back to the large panel
     * @param keyOf the key that shows a panel, in words; empty text where it has none
     */
    FoldedPanels(JComponent area, Runnable unfold, Runnable focusLarge, Function<DockPanel, String> keyOf) {
        this.area = area;
        this.focusLarge = focusLarge;
        this.keyOf = keyOf;
        strip.setName("folded-panels");
        open.setName("folded-open");
        JButton back = button("layout", "panels-unfold", "Put the panels back beside it");
        back.addActionListener(e -> unfold.run());
        strip.add(back, "w 36!, h 36!");
        JPanel head = new JPanel(new MigLayout("novisualpadding, insets 0 8 0 2, fill", "[grow, fill][]", "[fill]"));
        head.setOpaque(false);
        JButton close = button("close", "folded-close", "Fold it to the edge again (Escape)");
        close.addActionListener(e -> leave());
        head.add(title, "wmin 0");
        head.add(close, "w 36!, h 36!");
        open.add(head, BorderLayout.NORTH);
        open.getInputMap(JComponent.WHEN_ANCESTOR_OF_FOCUSED_COMPONENT).put(KeyStroke.getKeyStroke("ESCAPE"), "fold");
        open.getActionMap().put("fold", new AbstractAction() {
            @Override
            public void actionPerformed(ActionEvent e) {
                leave();
            }
        });
        LookColors.background(strip, SemanticColor.SURFACE_RAISED);
        LookColors.background(open, SemanticColor.SURFACE_RAISED);
        LookColors.border(strip, () -> BorderFactory.createMatteBorder(0, 1, 0, 0, SemanticColor.BORDER.get()));
        LookColors.border(open, () -> BorderFactory.createMatteBorder(0, 2, 0, 0, SemanticColor.ACCENT.get()));
        title.setFont(Fonts.strong());
    }

    private static JButton button(String icon, String name, String tip) {
        JButton button = new JButton(Icons.small(icon));
        button.setName(name);
        button.setToolTipText(tip);
        button.getAccessibleContext().setAccessibleName(tip);
        button.putClientProperty("JButton.buttonType", "toolBarButton");
        return button;
    }

    /** Folds panels. */
    void fold(List<DockPanel> folded) {
        for (DockPanel panel : folded) {
            JToggleButton button = new JToggleButton(panel.getIcon());
            button.setName("folded-" + panel.getPersistentID());
            String key = keyOf.apply(panel);
            button.setToolTipText(panel.title() + (key.isEmpty() ? "" : " (" + key + ")"));
            button.getAccessibleContext().setAccessibleName(panel.title());
            button.putClientProperty("JButton.buttonType", "toolBarButton");
            button.addActionListener(e -> {
                if (shown.equals(Optional.of(panel))) {
                    leave();
                } else {
                    show(panel);
                }
            });
            strip.add(button, "w 36!, h 36!");
            buttons.add(button);
            panels.add(panel);
        }
        area.add(open, 0);
        area.add(strip, 0);
        open.setVisible(false);
    }

    /** Puts all back into their panels. */
    void unfold() {
        close();
        buttons.forEach(strip::remove);
        buttons.clear();
        panels.clear();
        area.remove(open);
        area.remove(strip);
    }

    /** Whether it is one of those that are folded. */
    boolean has(DockPanel panel) {
        return panels.contains(panel);
    }

    /** Opens a folded panel over the edge, instead of the one that was open. */
    void show(DockPanel panel) {
        close();
        title.setText(panel.title());
        open.add(panel.content());
        open.setVisible(true);
        shown = Optional.of(panel);
        select();
        area.revalidate();
        area.repaint();
    }

    /** Folds the open panel to the edge again. */
    void close() {
        shown.ifPresent(panel -> {
            panel.takeBack();
            open.setVisible(false);
            shown = Optional.empty();
            area.revalidate();
            area.repaint();
        });
        select();
    }

    private void leave() {
        close();
        focusLarge.run();
    }

    /** The panel that lies over the edge. */
    Optional<DockPanel> shown() {
        return shown;
    }

    private void select() {
        for (int i = 0; i < buttons.size(); i++) {
            buttons.get(i).setSelected(shown.equals(Optional.of(panels.get(i))));
        }
    }

    /** Lays strip and open panel over an area; returns what is left of it for the large panel. */
    Rectangle layOut(Rectangle all) {
        Dimension size = strip.getPreferredSize();
        int left = all.x + all.width - size.width;
        strip.setBounds(left, all.y, size.width, all.height);
        int width = Math.min(Look.px(WIDTH), (int) (all.width * MOST));
        open.setBounds(Math.max(all.x, left - width), all.y, Math.min(width, left - all.x), all.height);
        return new Rectangle(all.x, all.y, Math.max(0, all.width - size.width), all.height);
    }
}
