package org.sami.ui.command;

import java.awt.Component;
import java.awt.Dimension;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.Stream;
import javax.swing.JButton;
import javax.swing.JPanel;
import javax.swing.JPopupMenu;
import org.sami.ui.look.Icons;
import org.sami.ui.look.Look;
import org.sami.ui.look.Spacing;

/**
 * A row of buttons that never cuts one: where there is no room for all words, the last buttons show their icons alone, and their tooltips say
 * the rest. What is added as lead stands at the left, the others at the right of it or at the right end. What is left out where there is no
 * room even so stands in the menu of a last button.
 */
public final class CommandRow extends JPanel {
    private final List<Component> left = new ArrayList<>();
    private final List<Component> right = new ArrayList<>();
    private final List<Component> spare = new ArrayList<>();
    private final Set<Component> leftOut = new HashSet<>();
    private final JButton more = new JButton(Icons.small("more"));

    /** An empty row. */
    public CommandRow() {
        super(null);
        more.setName("more-commands");
        more.setToolTipText("Commands that have no room here");
        more.getAccessibleContext().setAccessibleName("More commands");
        more.putClientProperty("JButton.buttonType", "toolBarButton");
        more.setMinimumSize(null);
        more.addActionListener(e -> menu().show(more, 0, more.getHeight()));
        more.setVisible(false);
        add(more);
    }

    /** What is left out, as the items of a menu. */
    JPopupMenu menu() {
        JPopupMenu menu = new JPopupMenu();
        menu.setName("more-commands-menu");
        Stream.concat(left.stream(), right.stream())
                .filter(leftOut::contains)
                .filter(each -> each instanceof CommandButton && each.isVisible())
                .map(each -> ((CommandButton) each).getAction())
                .forEach(menu::add);
        return menu;
    }

    /** Puts something at the left. */
    public CommandRow left(Component component) {
        left.add(component);
        add(component);
        return this;
    }

    /** Puts something at the right end. */
    public CommandRow right(Component component) {
        right.add(component);
        add(component);
        return this;
    }

    /** Puts something at the right end that is left out where there is no room for all: the first of them first. */
    public CommandRow spare(Component component) {
        right(component);
        return leaveOut(component);
    }

    /** Lets what is in the row be left out where there is no room for all, after those that may be left out already. */
    public CommandRow leaveOut(Component component) {
        spare.add(component);
        return this;
    }

    private int gap() {
        return Look.px(Spacing.TIGHT);
    }

    private int inset() {
        return Look.px(Spacing.NORMAL);
    }

    private int width(Component component) {
        return component.isVisible() && !leftOut.contains(component) ? component.getPreferredSize().width : 0;
    }

    private int moreWidth() {
        return Math.max(more.getPreferredSize().width, Look.px(Look.hitTarget()));
    }

    private int wanted() {
        return 2 * inset()
                + (leftOut.isEmpty() ? 0 : moreWidth() + gap())
                + left.stream().mapToInt(each -> width(each) + gap()).sum()
                + right.stream().mapToInt(each -> width(each) + gap()).sum();
    }

    @Override
    public Dimension getPreferredSize() {
        int height = 0;
        for (Component each : getComponents()) {
            height = Math.max(height, each.getPreferredSize().height);
        }
        return new Dimension(2 * inset(), height + 2 * gap());
    }

    @Override
    public Dimension getMinimumSize() {
        return getPreferredSize();
    }

    @Override
    public void doLayout() {
        leftOut.clear();
        words();
        for (int i = 0; i < spare.size() && wanted() > getWidth(); i++) {
            if (spare.get(i).isVisible()) {
                leftOut.add(spare.get(i));
            }
        }
        more.setVisible(!leftOut.isEmpty());
        int missing = wanted() - getWidth();
        int x = inset();
        for (Component each : left) {
            int width = width(each);
            if (missing > 0 && !(each instanceof CommandButton)) {
                int given = Math.max(0, width - missing);
                missing -= width - given;
                width = given;
            }
            x = place(each, x, width);
        }
        int end = getWidth() - inset();
        if (more.isVisible()) {
            place(more, Math.max(x, end - moreWidth()), moreWidth());
            end -= moreWidth() + gap();
        }
        for (int i = right.size() - 1; i >= 0; i--) {
            int width = width(right.get(i));
            place(right.get(i), Math.max(x, end - width), width);
            end -= width + (width > 0 ? gap() : 0);
        }
    }

    /** Takes words from the last buttons on, until all have room. */
    private void words() {
        List<CommandButton> buttons = new ArrayList<>();
        left.forEach(each -> collect(each, buttons));
        right.forEach(each -> collect(each, buttons));
        buttons.forEach(button -> button.setHideActionText(false));
        for (int i = buttons.size() - 1; i >= 0 && wanted() > getWidth(); i--) {
            buttons.get(i).setHideActionText(true);
        }
    }

    private static void collect(Component each, List<CommandButton> buttons) {
        if (each instanceof CommandButton button && button.getIcon() != null) {
            buttons.add(button);
        }
    }

    private int place(Component each, int x, int width) {
        int height = Math.min(getHeight(), each.getPreferredSize().height);
        each.setBounds(x, (getHeight() - height) / 2, width, height);
        return x + width + (width > 0 ? gap() : 0);
    }
}
