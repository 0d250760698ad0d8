package org.sami.spn.phase;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import org.sami.spn.model.InputEventSpec;
import org.sami.spn.model.MarkupSpec;
import org.sami.spn.model.OutputEventSpec;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Transition;
import org.sami.spn.value.EnumValue;
import org.sami.spn.value.TextValue;
import org.sami.spn.vocabulary.EventType;
import org.sami.spn.vocabulary.Reserved;
import org.sami.spn.vocabulary.Vocabulary;

/**
 * Finds the actions of a plan's phase chart, and to which each branch is an option: the nearest Phase Item backwards in the net
 * (thesis 5.2.3). A branch that names no phase belongs to that item's.
 */
final class PhaseReader {
    private record Marked(
            String vertex, String event, String label, Optional<MarkupSpec> item, Optional<MarkupSpec> branch) {}

    private final VertexGraph graph;
    private final Vocabulary vocabulary;
    private final Map<String, List<Marked>> marked = new LinkedHashMap<>();
    private final Map<String, PhaseAction> actions = new LinkedHashMap<>();
    private final Map<String, List<String>> options = new LinkedHashMap<>();

    PhaseReader(Plan plan, VertexGraph graph, Vocabulary vocabulary) {
        this.graph = graph;
        this.vocabulary = vocabulary;
        for (Place place : plan.places()) {
            for (OutputEventSpec output : place.outputs()) {
                mark(place.id(), place.name(), output.id(), output.type(), output.markups());
            }
        }
        for (Transition transition : plan.transitions()) {
            for (InputEventSpec input : transition.inputs()) {
                mark(transition.id(), transition.name(), input.id(), input.type(), input.markups());
            }
        }
        all().stream()
                .filter(m -> m.item().isPresent())
                .forEach(m -> add(m, text(m.item().get(), Reserved.PHASE_NAME)));
        all().stream().filter(m -> m.branch().isPresent()).forEach(this::addBranch);
    }

    private void mark(String vertex, String name, String event, String type, List<MarkupSpec> markups) {
        Optional<MarkupSpec> item = markup(markups, Reserved.PHASE_ITEM);
        Optional<MarkupSpec> branch = markup(markups, Reserved.PHASE_BRANCH);
        if (item.isPresent() || branch.isPresent()) {
            String label = !name.isEmpty()
                    ? name
                    : vocabulary.event(type).map(EventType::label).orElse(type);
            marked.computeIfAbsent(vertex, v -> new ArrayList<>()).add(new Marked(vertex, event, label, item, branch));
        }
    }

    private static Optional<MarkupSpec> markup(List<MarkupSpec> markups, String type) {
        return markups.stream().filter(m -> m.type().equals(type)).findFirst();
    }

    private static String text(MarkupSpec markup, String option) {
        return markup.option(option)
                .map(value -> value instanceof TextValue text
                        ? text.value()
                        : value instanceof EnumValue constant ? constant.constant() : "")
                .orElse("");
    }

    private List<Marked> all() {
        return marked.values().stream().flatMap(List::stream).toList();
    }

    private void add(Marked m, String phase) {
        MarkupSpec markup = m.branch().or(m::item).orElseThrow();
        String named = text(markup, Reserved.ACTION_NAME);
        actions.put(
                m.event(),
                new PhaseAction(
                        m.event(),
                        m.vertex(),
                        phase,
                        text(markup, Reserved.ACTOR),
                        named.isEmpty() ? m.label() : named,
                        m.branch().isPresent()));
    }

    private void addBranch(Marked m) {
        List<Marked> items = itemsBefore(m);
        String own = text(m.branch().orElseThrow(), Reserved.PHASE_NAME);
        if (!actions.containsKey(m.event())) {
            String phase = own.isEmpty() && !items.isEmpty()
                    ? Objects.requireNonNull(actions.get(items.get(0).event())).phase()
                    : own;
            add(m, phase);
        }
        items.forEach(item ->
                options.computeIfAbsent(item.event(), i -> new ArrayList<>()).add(m.event()));
    }

    /** The items of the same vertex before the event, the last of them; else those of the nearest vertices before it. */
    private List<Marked> itemsBefore(Marked branch) {
        List<Marked> here = marked.getOrDefault(branch.vertex(), List.of());
        List<Marked> before = here.subList(0, here.indexOf(branch)).stream()
                .filter(m -> m.item().isPresent())
                .toList();
        if (!before.isEmpty()) {
            return before.subList(before.size() - 1, before.size());
        }
        return graph.nearestBefore(branch.vertex(), v -> lastItem(v).isPresent()).stream()
                .map(v -> lastItem(v).orElseThrow())
                .toList();
    }

    private Optional<Marked> lastItem(String vertex) {
        return marked.getOrDefault(vertex, List.of()).stream()
                .filter(m -> m.item().isPresent())
                .reduce((a, b) -> b);
    }

    /** All actions by id, in the order of the plan: places before transitions. */
    Map<String, PhaseAction> actions() {
        return actions;
    }

    /** The ids of the branches that are options of an action, by its id. */
    Map<String, List<String>> options() {
        return options;
    }

    /** The ids of the actions on a vertex, in its order. */
    List<String> on(String vertex) {
        return marked.getOrDefault(vertex, List.of()).stream()
                .map(Marked::event)
                .toList();
    }
}
