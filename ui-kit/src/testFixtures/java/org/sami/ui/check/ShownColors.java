package org.sami.ui.check;

import java.awt.Color;
import java.awt.Component;
import java.awt.Container;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import javax.swing.CellRendererPane;
import javax.swing.JComponent;
import javax.swing.border.Border;
import javax.swing.border.CompoundBorder;
import javax.swing.border.LineBorder;
import javax.swing.border.MatteBorder;

/** The colours of components, in words that can be compared: of text, of what it lies on, of lines around it. On the event thread. */
public final class ShownColors {
    private ShownColors() {}

    /** Those of a component and all that is in it, a line each; cells take theirs when they are painted, and are left out. */
    public static List<String> of(Component component) {
        List<String> lines = new ArrayList<>();
        collect(component, lines);
        return lines;
    }

    private static void collect(Component component, List<String> lines) {
        StringBuilder line = new StringBuilder(component.getClass().getSimpleName())
                .append(' ')
                .append(component.getName())
                .append(words(" text ", component.getForeground()))
                .append(words(" on ", component.getBackground()));
        if (component instanceof JComponent swing) {
            line.append(words(swing.getBorder()));
        }
        lines.add(line.toString());
        if (component instanceof Container container && !(component instanceof CellRendererPane)) {
            for (Component child : container.getComponents()) {
                collect(child, lines);
            }
        }
    }

    private static String words(Border border) {
        if (border instanceof CompoundBorder both) {
            return words(both.getOutsideBorder()) + words(both.getInsideBorder());
        }
        return border instanceof MatteBorder matte
                ? words(" line ", matte.getMatteColor())
                : border instanceof LineBorder line ? words(" line ", line.getLineColor()) : "";
    }

    private static String words(String what, Color color) {
        return color == null ? "" : what + String.format(Locale.ROOT, "%06x", color.getRGB() & 0xFFFFFF);
    }
}
