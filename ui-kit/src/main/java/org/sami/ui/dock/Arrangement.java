package org.sami.ui.dock;

import io.github.andrewauclair.moderndocking.DockingRegion;
import io.github.andrewauclair.moderndocking.app.WindowLayoutBuilder;
import io.github.andrewauclair.moderndocking.layouts.ApplicationLayout;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * The program's first arrangement of panels in a window: each to the side of, below or behind one that is placed already. Some are folded to the
 * edge at first: they have a place, and take it when they are opened. Immutable.
 */
public final class Arrangement {
    private final String first;
    private final List<Step> steps;
    private final Set<String> folded;

    /** A panel that is placed at another. */
    record Step(String panel, String at, DockingRegion region, double part) {}

    private Arrangement(String first, List<Step> steps, Set<String> folded) {
        this.first = first;
        this.steps = steps;
        this.folded = folded;
    }

    /** One panel fills the window. */
    public static Arrangement of(String panel) {
        return new Arrangement(panel, List.of(), Set.of());
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

    /** The same with panels that are folded to the edge until somebody opens them. */
    public Arrangement folding(String... panels) {
        return new Arrangement(first, steps, Set.of(panels));
    }

    /** Whether some panels are folded at first. */
    boolean folds() {
        return !folded.isEmpty();
    }

    /** The same as far as some panels are concerned, none of which is folded. */
    Arrangement with(Set<String> placed) {
        return new Arrangement(first, steps, Set.of()).of(placed);
    }

    /**
     * Where a panel is placed among those that are placed already: behind one of its stack, else where its stack lies. Empty where it is the
     * first one, or none of those that it lies at has a place.
     */
    Optional<Step> home(String panel, Predicate<String> isPlaced) {
        String head = head(panel);
        Optional<String> stack = all().filter(each -> head(each).equals(head) && isPlaced.test(each))
                .findFirst();
        if (stack.isPresent()) {
            return Optional.of(new Step(panel, stack.get(), DockingRegion.CENTER, 0.5));
        }
        return step(head).flatMap(step -> {
            Optional<String> at = all().filter(each -> head(each).equals(head(step.at)) && isPlaced.test(each))
                    .findFirst();
            return at.isPresent()
                    ? at.map(found -> new Step(panel, found, step.region, step.part))
                    : home(step.at, isPlaced).map(there -> new Step(panel, there.at, there.region, there.part));
        });
    }

    private Stream<String> all() {
        return Stream.concat(Stream.of(first), steps.stream().map(Step::panel));
    }

    private Optional<Step> step(String panel) {
        return steps.stream().filter(step -> step.panel.equals(panel)).findFirst();
    }

    /** The panel behind which another lies, at any depth: the one that has a place of its own. */
    private String head(String panel) {
        return step(panel)
                .filter(step -> step.region == DockingRegion.CENTER)
                .map(step -> head(step.at))
                .orElse(panel);
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
        return new Arrangement(first, more, folded);
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
                        .orElseGet(() -> new Arrangement(first, others(step), folded))
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
        return new Arrangement(first.equals(missing) ? heir.panel : first, next, folded);
    }

    private List<Step> others(Step without) {
        return steps.stream().filter(step -> !step.equals(without)).toList();
    }

    /** As Modern Docking has it, without those that are folded; of panels in a stack the first stands in front. */
    ApplicationLayout layout() {
        if (folds()) {
            return with(all().filter(panel -> !folded.contains(panel)).collect(Collectors.toSet()))
                    .layout();
        }
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
