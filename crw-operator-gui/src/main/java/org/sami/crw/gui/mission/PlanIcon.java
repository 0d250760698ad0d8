package org.sami.crw.gui.mission;

import java.awt.Component;
import java.awt.Graphics;
import javax.swing.Icon;
import org.sami.crw.operator.mission.PlanTree;
import org.sami.ui.look.Icons;
import org.sami.ui.look.Look;

/** What stands before a line of the mission tree: as much room as it stands deep in it, and the sign of a folder. */
record PlanIcon(int depth, boolean folder) implements Icon {
    private static final int STEP = 16;

    static PlanIcon of(PlanTree.Line line) {
        return new PlanIcon(line.depth(), line.plan().isEmpty());
    }

    @Override
    public void paintIcon(Component component, Graphics graphics, int x, int y) {
        if (folder) {
            Icons.small("folder").paintIcon(component, graphics, x + Look.px(STEP) * depth, y);
        }
    }

    @Override
    public int getIconWidth() {
        return Look.px(STEP) * depth + (folder ? Icons.small("folder").getIconWidth() : 0);
    }

    @Override
    public int getIconHeight() {
        return Icons.small("folder").getIconHeight();
    }
}
