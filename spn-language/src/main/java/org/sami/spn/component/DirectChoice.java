package org.sami.spn.component;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import org.sami.spn.value.NamedType;
import org.sami.spn.value.ValueType;

/**
 * Algorithm 5 of thesis 5.2.4: the one component that can handle a type, with its widgets, and acts on the most markup.
 *
 * <p>A choice of a markup counts once however many widgets act on it; the thesis's lines 23 to 27 would count it for each, beyond the
 * highest score that its text names.
 */
final class DirectChoice {
    private final ComponentLibrary library;
    private final Map<String, NamedType> declarations;

    DirectChoice(ComponentLibrary library, Map<String, NamedType> declarations) {
        this.library = Objects.requireNonNull(library, "library");
        this.declarations = Objects.requireNonNull(declarations, "declarations");
    }

    /** The best one: the highest score, then the fewest widgets, then the earliest of the domain. */
    Optional<ChosenComponent.Direct> best(Purpose purpose, ValueType type, List<MarkupOption> wanted) {
        return candidates(purpose, type, wanted).stream()
                .flatMap(candidate -> candidate.direct().stream())
                .min(Comparator.comparingInt((ChosenComponent.Direct direct) -> -direct.score())
                        .thenComparingInt(direct -> direct.widgets().size()));
    }

    /** How each component does, in the order of the domain. */
    List<Candidate> candidates(Purpose purpose, ValueType type, List<MarkupOption> wanted) {
        return library.components().stream()
                .map(component -> new Candidate(component, use(component, purpose, type, wanted)))
                .toList();
    }

    private Optional<ChosenComponent.Direct> use(
            ComponentType component, Purpose purpose, ValueType type, List<MarkupOption> wanted) {
        if (!handles(component, component.widgets(), purpose, type)) {
            return Optional.empty();
        }
        List<MarkupOption> actsOn = wanted.stream()
                .filter(option -> actsOn(component, component.widgets(), option))
                .toList();
        return fewest(component, purpose, type, actsOn)
                .map(widgets -> new ChosenComponent.Direct(component, widgets, type, actsOn));
    }

    /** The smallest set of widgets that does all of it; of equal ones that of the widgets named first. */
    private Optional<List<WidgetType>> fewest(
            ComponentType component, Purpose purpose, ValueType type, List<MarkupOption> actsOn) {
        Optional<List<WidgetType>> best = Optional.empty();
        for (int set = 0; set < 1 << component.widgets().size(); set++) {
            if (best.isEmpty() || Integer.bitCount(set) < best.get().size()) {
                List<WidgetType> widgets = widgets(component, set);
                if (handles(component, widgets, purpose, type)
                        && actsOn.stream().allMatch(option -> actsOn(component, widgets, option))) {
                    best = Optional.of(widgets);
                }
            }
        }
        return best;
    }

    private static List<WidgetType> widgets(ComponentType component, int set) {
        List<WidgetType> widgets = new ArrayList<>();
        for (int i = 0; i < component.widgets().size(); i++) {
            if ((set & 1 << i) != 0) {
                widgets.add(component.widgets().get(i));
            }
        }
        return widgets;
    }

    private boolean handles(ComponentType component, List<WidgetType> widgets, Purpose purpose, ValueType type) {
        return component.can().supports(purpose, type, declarations)
                || widgets.stream().anyMatch(widget -> widget.can().supports(purpose, type, declarations));
    }

    private static boolean actsOn(ComponentType component, List<WidgetType> widgets, MarkupOption option) {
        return component.can().actsOn(option)
                || widgets.stream().anyMatch(widget -> widget.can().actsOn(option));
    }
}
