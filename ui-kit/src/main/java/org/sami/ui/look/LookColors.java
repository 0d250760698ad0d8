package org.sami.ui.look;

import java.awt.Color;
import java.beans.PropertyChangeEvent;
import java.beans.PropertyChangeListener;
import java.util.function.Consumer;
import java.util.function.Supplier;
import javax.swing.JComponent;
import javax.swing.border.Border;
import org.sami.palette.SemanticColor;

/**
 * Colours and borders of components that are those of the look in force at any time: they are set at once, and again whenever the look
 * changes. A component that is given a bare {@link Color} keeps that of the look in which it was made. On the event thread.
 */
public final class LookColors {
    private LookColors() {}

    /** Gives a component the colour of its text and marks, instead of the one before. */
    public static void foreground(JComponent component, SemanticColor color) {
        Kept kept = Kept.of(component);
        kept.foreground = now -> now.setForeground(color.get());
        kept.foreground.accept(component);
    }

    /** Gives a component the colour of what it lies on, instead of the one before. */
    public static void background(JComponent component, SemanticColor color) {
        Kept kept = Kept.of(component);
        kept.background = now -> now.setBackground(color.get());
        kept.background.accept(component);
    }

    /**
     * Gives a component a border, instead of the one before.
     *
     * @param border makes it; asked again at each change of theme or scale
     */
    public static void border(JComponent component, Supplier<Border> border) {
        Kept kept = Kept.of(component);
        kept.border = now -> now.setBorder(border.get());
        kept.border.accept(component);
    }

    /** What a component is given each time that it takes its look. */
    private static final class Kept implements PropertyChangeListener {
        private Consumer<JComponent> foreground = component -> {};
        private Consumer<JComponent> background = component -> {};
        private Consumer<JComponent> border = component -> {};

        /** What that component has; made where it has none yet. */
        static Kept of(JComponent component) {
            if (component.getClientProperty(Kept.class) instanceof Kept kept) {
                return kept;
            }
            Kept kept = new Kept();
            component.putClientProperty(Kept.class, kept);
            component.addPropertyChangeListener("UI", kept);
            return kept;
        }

        @Override
        public void propertyChange(PropertyChangeEvent taken) {
            JComponent component = (JComponent) taken.getSource();
            foreground.accept(component);
            background.accept(component);
            border.accept(component);
        }
    }
}
