package org.sami.ui.dock;

import io.github.andrewauclair.moderndocking.ui.DockingHeaderUI;
import io.github.andrewauclair.moderndocking.ui.HeaderController;
import io.github.andrewauclair.moderndocking.ui.HeaderModel;
import java.awt.BorderLayout;
import java.awt.Color;
import java.awt.Dimension;
import java.util.Optional;
import javax.swing.BorderFactory;
import javax.swing.Icon;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JMenuItem;
import javax.swing.JPanel;
import javax.swing.JPopupMenu;
import org.sami.palette.SemanticColor;
import org.sami.ui.look.Fonts;
import org.sami.ui.look.Icons;
import org.sami.ui.look.Look;
import org.sami.ui.look.LookColors;
import org.sami.ui.look.Spacing;

/** The line above a panel: its title, which it is dragged by, and a menu of what can be done with the panel. */
final class DockHeader extends JPanel implements DockingHeaderUI {
    private final HeaderController controller;
    private final HeaderModel model;
    private final JLabel title;
    private final JButton more;
    private final transient Optional<JButton> fold;
    private final boolean foldable;

    /**
     * The line above one panel.
     *
     * @param id of the panel; begins the names of the buttons
     * @param foldable whether the panel is folded to the edge and not closed
     */
    DockHeader(String id, String name, Icon icon, boolean foldable, HeaderController controller, HeaderModel model) {
        super(new BorderLayout());
        this.controller = controller;
        this.model = model;
        this.foldable = foldable;
        controller.setUI(this);
        title = new JLabel(name, icon, JLabel.LEADING);
        more = new JButton(Icons.small("more")) {
            @Override
            public Dimension getPreferredSize() {
                Dimension size = super.getPreferredSize();
                return new Dimension(Math.max(size.width, Look.px(Look.hitTarget())), size.height);
            }
        };
        more.setName(id + "-menu");
        more.putClientProperty("JButton.buttonType", "toolBarButton");
        more.addActionListener(e -> displaySettingsMenu(more));
        add(title);
        fold = foldable ? Optional.of(foldButton(id)) : Optional.empty();
        JPanel buttons = new JPanel(new BorderLayout());
        buttons.setOpaque(false);
        fold.ifPresent(button -> buttons.add(button, BorderLayout.WEST));
        buttons.add(more);
        add(buttons, BorderLayout.EAST);
        retitle(name);
        colour();
    }

    /** Shows another title, of which its buttons speak as well. */
    final void retitle(String name) {
        title.setText(name);
        more.setToolTipText("Set " + name + " free, enlarge or " + (foldable ? "fold" : "close") + " it");
        more.getAccessibleContext().setAccessibleName("Menu of " + name);
        fold.ifPresent(button -> {
            button.setToolTipText("Fold " + name + " to the edge");
            button.getAccessibleContext().setAccessibleName("Fold " + name + " to the edge");
        });
    }

    private JButton foldButton(String id) {
        JButton button = new JButton(Icons.small("right"));
        button.setName(id + "-fold");
        button.putClientProperty("JButton.buttonType", "toolBarButton");
        button.addActionListener(e -> controller.close());
        return button;
    }

    private void colour() {
        LookColors.background(this, SemanticColor.SURFACE_RAISED);
        LookColors.border(
                this,
                () -> BorderFactory.createCompoundBorder(
                        BorderFactory.createMatteBorder(0, 0, 1, 0, SemanticColor.BORDER.get()),
                        BorderFactory.createEmptyBorder(0, Look.px(Spacing.NORMAL), 0, 0)));
        if (title != null) {
            title.setFont(Fonts.strong());
            LookColors.foreground(title, SemanticColor.TEXT);
        }
    }

    @Override
    public void updateUI() {
        super.updateUI();
        if (title != null) {
            colour();
        }
    }

    @Override
    public void displaySettingsMenu(JButton below) {
        JPopupMenu menu = new JPopupMenu();
        menu.add(item("Own window", model.isFloatingAllowed(), controller::newWindow));
        menu.add(
                model.isMaximized()
                        ? item("Back to its size", true, controller::minimize)
                        : item("Enlarge", model.isMaximizeAllowed(), controller::maximize));
        menu.add(item(foldable ? "Fold to the edge" : "Close", model.isCloseAllowed(), controller::close));
        menu.show(below, 0, below.getHeight());
    }

    private static JMenuItem item(String text, boolean enabled, Runnable action) {
        JMenuItem item = new JMenuItem(text);
        item.setEnabled(enabled);
        item.addActionListener(e -> action.run());
        return item;
    }

    @Override
    public void update() {
        // a panel says itself when its title changes
    }

    @Override
    public void setBackgroundOverride(Color color) {
        // the colours are the theme's
    }

    @Override
    public void setForegroundOverride(Color color) {
        // the colours are the theme's
    }
}
