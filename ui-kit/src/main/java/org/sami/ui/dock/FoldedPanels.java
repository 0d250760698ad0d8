package org.sami.ui.dock;

import java.awt.BorderLayout;
import java.awt.Dimension;
import java.awt.Insets;
import java.awt.Rectangle;
import java.awt.event.ActionEvent;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Function;
import javax.swing.AbstractAction;
import javax.swing.BorderFactory;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JToggleButton;
import javax.swing.KeyStroke;
import javax.swing.SwingConstants;
import net.miginfocom.swing.MigLayout;
import org.sami.palette.SemanticColor;
import org.sami.ui.look.Fonts;
import org.sami.ui.look.Icons;
import org.sami.ui.look.Look;
import org.sami.ui.look.LookColors;

/**
 * Panels folded to the right edge: a strip with a button for each. While one panel has all the room, the one that is open lies over the edge
 * of the large one, which keeps its size. On the event thread.
 */
final class FoldedPanels {
    private static final int WIDTH = 400;
    private static final int UNFOLD = 48;
    private static final int WITH_LABEL = 52;
    private static final String ICON = "w 36!, h 36!";
    private static final String LABELLED = "wmin 64, growx, h 48!";
    private static final double MOST = 0.6; // of the area's width

    private final JComponent area;
    private final Function<DockPanel, String> keyOf;
    private final Runnable focusLarge;
    private final Consumer<DockPanel> pressed;
    private final MigLayout strips = new MigLayout("novisualpadding, insets 4, gap 4, wrap 1", "[center]", "[]");
    private final JPanel strip = new JPanel(strips);
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
     * @param pressed receives whose button was pressed
     * @param keyOf the key that shows a panel, in words; empty text where it has none
     */
    FoldedPanels(
            JComponent area,
            Runnable unfold,
            Runnable focusLarge,
            Consumer<DockPanel> pressed,
            Function<DockPanel, String> keyOf) {
        this.area = area;
        this.focusLarge = focusLarge;
        this.pressed = pressed;
        this.keyOf = keyOf;
        strip.setName("folded-panels");
        open.setName("folded-open");
        JButton back = button("layout", "panels-unfold", "Put the panels back next to it");
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

    /** Folds panels, and no others. */
    void fold(List<DockPanel> folded) {
        if (folded.equals(panels)) {
            return;
        }
        unfold();
        if (folded.isEmpty()) {
            return;
        }
        for (DockPanel panel : folded) {
            JToggleButton button = new JToggleButton(panel.getIcon());
            button.setName("folded-" + panel.getPersistentID());
            String key = keyOf.apply(panel);
            button.setToolTipText(panel.title() + (key.isEmpty() ? "" : " (" + key + ")"));
            button.getAccessibleContext().setAccessibleName(panel.title());
            button.putClientProperty("JButton.buttonType", "toolBarButton");
            button.addActionListener(e -> pressed.accept(panel));
            button.setVerticalTextPosition(SwingConstants.BOTTOM);
            button.setHorizontalTextPosition(SwingConstants.CENTER);
            button.setFont(Fonts.small());
            button.setMargin(new Insets(2, 2, 2, 2));
            strip.add(button, ICON);
            buttons.add(button);
            panels.add(panel);
        }
        area.add(open, 0);
        area.add(strip, 0);
        open.setVisible(false);
        area.revalidate();
        area.repaint();
    }

    /** Opens a panel over the edge, or folds it again where it is open. */
    void toggle(DockPanel panel) {
        if (shown.equals(Optional.of(panel))) {
            leave();
        } else {
            show(panel);
        }
    }

    /** Whether any panel is folded. */
    boolean isShown() {
        return !panels.isEmpty();
    }

    /** Puts all back into their panels. */
    void unfold() {
        close();
        buttons.forEach(strip::remove);
        buttons.clear();
        panels.clear();
        area.remove(open);
        area.remove(strip);
        area.revalidate();
        area.repaint();
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

    /** Where there is room the buttons have the names of their panels below their icons. */
    private void label(boolean labelled) {
        for (int i = 0; i < buttons.size(); i++) {
            buttons.get(i).setText(labelled ? panels.get(i).title() : "");
            strips.setComponentConstraints(buttons.get(i), labelled ? LABELLED : ICON);
        }
    }

    private void select() {
        for (int i = 0; i < buttons.size(); i++) {
            buttons.get(i).setSelected(shown.equals(Optional.of(panels.get(i))));
        }
    }

    /** Lays strip and open panel over an area; returns what is left of it for the large panel. */
    Rectangle layOut(Rectangle all) {
        label(all.height >= Look.px(UNFOLD + buttons.size() * WITH_LABEL));
        Dimension size = strip.getPreferredSize();
        int left = all.x + all.width - size.width;
        strip.setBounds(left, all.y, size.width, all.height);
        int width = Math.min(Look.px(WIDTH), (int) (all.width * MOST));
        open.setBounds(Math.max(all.x, left - width), all.y, Math.min(width, left - all.x), all.height);
        return new Rectangle(all.x, all.y, Math.max(0, all.width - size.width), all.height);
    }
}
