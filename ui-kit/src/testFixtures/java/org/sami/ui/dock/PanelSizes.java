package org.sami.ui.dock;

import io.github.andrewauclair.moderndocking.DockingRegion;
import java.awt.Dimension;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.sami.ui.look.Look;

/** How large each panel of an arrangement is in an area, without a window: for checks of what is in them. */
public final class PanelSizes {
    private static final int DIVIDER = 8;
    private static final int HEADER = 26;
    private static final int TABS = 34;
    private static final int STRIP = 44;
    private static final int LABELLED_STRIP = 88;
    private static final int LEAST_LABELLED = 420;

    /** Panels in one place. */
    private record Stack(List<String> panels, Dimension size) {}

    private final Map<String, Stack> stacks = new LinkedHashMap<>();

    private PanelSizes() {}

    /** The sizes by the ids of the panels, below their headers, at the scale in force. */
    public static Map<String, Dimension> of(Arrangement arrangement, Dimension area) {
        PanelSizes all = new PanelSizes();
        int strip = area.height < Look.px(LEAST_LABELLED) ? STRIP : LABELLED_STRIP;
        Dimension room = arrangement.folds() ? new Dimension(area.width - Look.px(strip), area.height) : area;
        all.stacks.put(arrangement.first(), new Stack(new ArrayList<>(List.of(arrangement.first())), room));
        arrangement.steps().forEach(all::place);
        Map<String, Dimension> sizes = new LinkedHashMap<>();
        all.stacks.forEach((panel, stack) -> {
            int above = Look.px(HEADER + (stack.panels.size() > 1 ? TABS : 0));
            sizes.put(panel, new Dimension(stack.size.width, stack.size.height - above));
        });
        return sizes;
    }

    private void place(Arrangement.Step step) {
        Stack at = stacks.get(step.at());
        if (step.region() == DockingRegion.CENTER) {
            at.panels.add(step.panel());
            stacks.put(step.panel(), at);
            return;
        }
        boolean beside = step.region() == DockingRegion.EAST || step.region() == DockingRegion.WEST;
        int all = (beside ? at.size.width : at.size.height) - Look.px(DIVIDER);
        int taken = (int) (all * step.part());
        Stack rest = new Stack(at.panels, sized(at.size, beside, all - taken));
        at.panels.forEach(panel -> stacks.put(panel, rest));
        stacks.put(step.panel(), new Stack(new ArrayList<>(List.of(step.panel())), sized(at.size, beside, taken)));
    }

    private static Dimension sized(Dimension size, boolean beside, int length) {
        return beside ? new Dimension(length, size.height) : new Dimension(size.width, length);
    }
}
