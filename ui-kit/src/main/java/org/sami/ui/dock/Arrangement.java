package org.sami.ui.dock;

import io.github.andrewauclair.moderndocking.DockingRegion;
import io.github.andrewauclair.moderndocking.app.WindowLayoutBuilder;
import io.github.andrewauclair.moderndocking.layouts.ApplicationLayout;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;

/** How panels lie in a window, as the program wants it first: each beside, below or behind one that is placed already. Immutable. */
public final class Arrangement {
    private final String first;
    private final List<Step> steps;

    /** A panel that is placed at another. */
    record Step(String panel, String at, DockingRegion region, double part) {}

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

    /** A panel to the left of another, of whose width it takes a part. */
    public Arrangement left(String panel, String of, double part) {
        return with(new Step(panel, of, DockingRegion.WEST, part));
    }

    /** A panel below another, of whose height it takes a part. */
    public Arrangement below(String panel, String of, double part) {
        return with(new Step(panel, of, DockingRegion.SOUTH, part));
    }

    /** A panel behind another, as a tab. */
    public Arrangement behind(String panel, String of) {
        return with(new Step(panel, of, DockingRegion.CENTER, 0.5));
    }

    /** The panel that fills the window first. */
    String first() {
        return first;
    }

    /** The others, in the order in which they are placed. */
    List<Step> steps() {
        return List.copyOf(steps);
    }

    private Arrangement with(Step step) {
        List<Step> more = new ArrayList<>(steps);
        more.add(step);
        return new Arrangement(first, more);
    }

    /**
     * The same where some panels are missing: the first that was placed by a missing one takes its place.
     *
     * @throws IllegalArgumentException if none of the panels is there
     */
    Arrangement of(Set<String> present) {
        if (!present.contains(first)) {
            return steps.stream()
                    .filter(step -> step.at.equals(first))
                    .findFirst()
                    .map(heir -> inherited(first, heir).of(present))
                    .orElseThrow(() -> new IllegalArgumentException("there is no panel to arrange"));
        }
        for (Step step : steps) {
            if (!present.contains(step.panel)) {
                return steps.stream()
                        .filter(each -> each.at.equals(step.panel))
                        .findFirst()
                        .map(heir -> inherited(step.panel, heir))
                        .orElseGet(() -> new Arrangement(first, others(step)))
                        .of(present);
            }
        }
        return this;
    }

    private Arrangement inherited(String missing, Step heir) {
        List<Step> next = others(heir).stream()
                .map(step -> new Step(
                        step.panel.equals(missing) ? heir.panel : step.panel,
                        step.at.equals(missing) ? heir.panel : step.at,
                        step.region,
                        step.part))
                .toList();
        return new Arrangement(first.equals(missing) ? heir.panel : first, next);
    }

    private List<Step> others(Step without) {
        return steps.stream().filter(step -> !step.equals(without)).toList();
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
