package org.sami.ui.command;

import com.formdev.flatlaf.FlatClientProperties;
import java.awt.Dimension;
import java.awt.event.HierarchyEvent;
import java.awt.event.MouseEvent;
import java.util.function.LongSupplier;
import javax.swing.JButton;
import org.sami.palette.SemanticColor;
import org.sami.ui.look.Icons;
import org.sami.ui.look.Look;
import org.sami.ui.look.Spacing;

/** A button for a command: named by its id, as large as a wet finger needs. */
public final class CommandButton extends JButton {
    private static final int ICON = 20;

    private static final String PRIMARY =
            "background: $Button.default.background; foreground: $Button.default.foreground; font: bold;"
                    + " focusedBackground: $Button.default.focusedBackground;"
                    + " focusedBorderColor: $Button.default.focusedBorderColor;"
                    + " hoverBackground: $Button.default.hoverBackground;"
                    + " pressedBackground: $Button.default.pressedBackground";

    private boolean confirms;
    private long shownMs; // by the clock of events

    /** A button with icon and title. */
    public CommandButton(Command command) {
        super(command);
        setName(command.id());
        setVisible(!command.isHidden());
        setIconTextGap(Look.px(Spacing.TIGHT));
    }

    /** A button with the icon alone; the tooltip says what it does. */
    public static CommandButton iconOnly(Command command) {
        CommandButton button = new CommandButton(command);
        button.setHideActionText(true);
        button.putClientProperty("JButton.buttonType", "toolBarButton");
        return button;
    }

    /**
     * The button of a panel that is pressed most: in the theme's strongest colours, which a line inside the ring shows to have the focus.
     *
     * @param icon a name of {@link Icons}
     */
    public static CommandButton primary(Command command, String icon) {
        CommandButton button = new CommandButton(command);
        button.setPrimary(true, icon);
        return button;
    }

    /**
     * Whether it is the button of a panel that is to be pressed next: in the theme's strongest colours, or as others are. It keeps its place either way.
     *
     * @param icon a name of {@link Icons}
     */
    public void setPrimary(boolean primary, String icon) {
        putClientProperty(FlatClientProperties.STYLE, primary ? PRIMARY : null);
        setIcon(primary ? Icons.of(icon, ICON, SemanticColor.ON_ACCENT) : Icons.normal(icon));
        setDisabledIcon(Icons.of(icon, ICON, SemanticColor.DISABLED));
    }

    /**
     * A button that confirms what another one has asked, or leaves it: it takes no second click of a double click, and none that was made before it was shown, as on
     * a machine that answers late. Such a click was meant for what was under the pointer before.
     */
    public static CommandButton confirming(Command command) {
        return confirming(command, System::currentTimeMillis);
    }

    /** The same by another clock than that of the window's events, in ms. */
    static CommandButton confirming(Command command, LongSupplier clockMs) {
        CommandButton button = new CommandButton(command);
        button.confirms = true;
        button.addHierarchyListener(e -> {
            if ((e.getChangeFlags() & HierarchyEvent.SHOWING_CHANGED) != 0) {
                button.shownMs = clockMs.getAsLong();
            }
        });
        return button;
    }

    @Override
    protected void processMouseEvent(MouseEvent e) {
        if (!confirms || (e.getClickCount() < 2 && e.getWhen() >= shownMs)) {
            super.processMouseEvent(e);
        }
    }

    /** Without its words it keeps them as its name for those who do not see it. */
    @Override
    public void setHideActionText(boolean hidden) {
        super.setHideActionText(hidden);
        getAccessibleContext()
                .setAccessibleName(hidden && getAction() instanceof Command command ? command.title() : null);
    }

    @Override
    public Dimension getPreferredSize() {
        Dimension size = super.getPreferredSize();
        int least = Look.px(Spacing.HIT_TARGET_FIELD);
        return new Dimension(Math.max(least, size.width), Math.max(least, size.height));
    }

    @Override
    public Dimension getMinimumSize() {
        return getPreferredSize();
    }
}
