package org.sami.ui.dock;

import io.github.andrewauclair.moderndocking.DockingRegion;
import io.github.andrewauclair.moderndocking.app.WindowLayoutBuilder;
import io.github.andrewauclair.moderndocking.layouts.ApplicationLayout;
import java.util.ArrayList;
import java.util.List;

/** How panels lie in a window, as the program wants it first: each beside, below or behind one that is placed already. Immutable. */
public final class Arrangement {
    private final String first;
    private final List<Step> steps;

    private record Step(String panel, String at, DockingRegion region, double part) {}

    private Arrangement(String first, List<Step> steps) {
        this.first = first;
        this.steps = steps;
    }

    /** One panel fills the window. */
    public static Arrangement of(String panel) {
        return new Arrangement(panel, List.of());
    }

    /** A panel to the right of another, of whose width it takes a part. */
    public Arrangement right(String panel, String of, double part) {
        return with(new Step(panel, of, DockingRegion.EAST, part));
    }

    /** A panel below another, of whose height it takes a part. */
    public Arrangement below(String panel, String of, double part) {
        return with(new Step(panel, of, DockingRegion.SOUTH, part));
    }

    /** A panel behind another, as a tab. */
    public Arrangement behind(String panel, String of) {
        return with(new Step(panel, of, DockingRegion.CENTER, 0.5));
    }

    private Arrangement with(Step step) {
        List<Step> more = new ArrayList<>(steps);
        more.add(step);
        return new Arrangement(first, more);
    }

    /** As Modern Docking has it; of panels in a stack the first stands in front. */
    ApplicationLayout layout() {
        WindowLayoutBuilder builder = new WindowLayoutBuilder(first);
        for (Step step : steps) {
            builder.dock(step.panel, step.at, step.region, step.part);
        }
        for (Step step : steps) {
            if (step.region == DockingRegion.CENTER) {
                builder.display(step.at);
            }
        }
        return builder.buildApplicationLayout();
    }
}
