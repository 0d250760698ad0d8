package org.sami.dreamm.tree;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Objects;
import java.util.stream.Stream;
import org.sami.spn.drawing.RequirementWords;
import org.sami.spn.edit.Usage;
import org.sami.spn.model.FieldSource;
import org.sami.spn.model.InEdge;
import org.sami.spn.model.MarkupSpec;
import org.sami.spn.model.OutEdge;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.model.Transition;
import org.sami.spn.model.VariableSpec;
import org.sami.spn.naming.ElementNames;
import org.sami.spn.value.TypeNames;
import org.sami.spn.value.Value;
import org.sami.spn.vocabulary.Vocabulary;
import org.sami.ui.value.ValueSummary;

/** Finds text in all that a project says: names, ids, events with fields and variables, requirements, markup, notes, test cases. */
final class ProjectSearch {
    private static final int MOST = 500;

    private final Project project;
    private final Vocabulary vocabulary;
    private final List<Hit> all = new ArrayList<>();

    ProjectSearch(Project project, Vocabulary vocabulary) {
        this.project = Objects.requireNonNull(project, "project");
        this.vocabulary = Objects.requireNonNull(vocabulary, "vocabulary");
        variables("", project.globals());
        project.plans().forEach(this::collect);
    }

    /** What holds each of the words that are typed, in the order of the document. */
    List<Hit> find(String typed) {
        List<String> words = Stream.of(typed.toLowerCase(Locale.ROOT).strip().split("\\s+"))
                .filter(word -> !word.isEmpty())
                .toList();
        return words.isEmpty()
                ? List.of()
                : all.stream().filter(hit -> holds(hit, words)).limit(MOST).toList();
    }

    private static boolean holds(Hit hit, List<String> words) {
        String text = (hit.title() + " " + hit.detail() + " " + hit.element()).toLowerCase(Locale.ROOT);
        return words.stream().allMatch(text::contains);
    }

    /** Where something is used, as what shows it. */
    List<Hit> of(List<Usage> usages) {
        return usages.stream()
                .map(usage -> new Hit(
                        usage.plan(),
                        project.plan(usage.plan())
                                .map(plan -> shown(plan, usage.element()))
                                .orElse(""),
                        project.plan(usage.plan())
                                .flatMap(plan -> new ElementNames(plan, vocabulary).of(usage.element()))
                                .orElseGet(() -> usage.element().isEmpty() ? where(usage) : usage.element()),
                        usage.where()
                                + project.plan(usage.plan())
                                        .map(plan -> " · " + PlanTree.name(plan))
                                        .orElse("")))
                .toList();
    }

    private String where(Usage usage) {
        return project.plan(usage.plan()).map(PlanTree::name).orElse("The project");
    }

    /** The vertex or edge that shows an element: itself, or the vertex of an event or a sub-mission. */
    static String shown(Plan plan, String element) {
        for (Place place : plan.places()) {
            boolean holds = place.outputs().stream().anyMatch(e -> e.id().equals(element))
                    || place.subMissions().stream().anyMatch(s -> s.id().equals(element));
            if (holds || place.id().equals(element)) {
                return place.id();
            }
        }
        for (Transition transition : plan.transitions()) {
            if (transition.id().equals(element) || transition.inputs().stream().anyMatch(e -> e.id().equals(element))) {
                return transition.id();
            }
        }
        boolean edge = plan.inEdges().stream().anyMatch(e -> e.id().equals(element))
                || plan.outEdges().stream().anyMatch(e -> e.id().equals(element));
        return edge ? element : "";
    }

    private void collect(Plan plan) {
        String name = PlanTree.name(plan);
        add(plan, "", name, "plan " + plan.id());
        if (!plan.description().isEmpty()) {
            add(plan, "", plan.description(), "description of " + name);
        }
        plan.notes().forEach(note -> add(plan, "", note.text(), "note of " + name));
        variables(plan.id(), plan.variables());
        plan.tasks().forEach(task -> add(plan, "", task.name(), "task of class " + task.taskClass() + " · " + name));
        plan.places().forEach(place -> place(plan, place));
        plan.transitions().forEach(transition -> transition(plan, transition));
        plan.inEdges().forEach(edge -> edge(plan, edge));
        plan.outEdges().forEach(edge -> edge(plan, edge));
        plan.testCases().forEach(test -> add(plan, "", test.name(), "test case of " + name));
        plan.queries().forEach(query -> add(plan, "", query.name() + ": " + query.text(), "query of " + name));
    }

    private void place(Plan plan, Place place) {
        ElementNames names = new ElementNames(plan, vocabulary);
        add(plan, place.id(), names.of(place), "place · " + PlanTree.name(plan));
        place.outputs().forEach(event -> {
            StringBuilder detail = new StringBuilder(label(event.type()));
            event.fields()
                    .forEach((field, source) ->
                            detail.append(", ").append(field).append(" = ").append(words(source)));
            add(plan, place.id(), event.type(), rest(detail, event.writes(), event.markups(), plan));
        });
        place.subMissions().forEach(sub -> {
            StringBuilder detail = new StringBuilder("sub-mission at ").append(names.of(place));
            sub.variables()
                    .forEach((child, parent) ->
                            detail.append(", ").append(child).append(" from ").append(parent));
            add(plan, place.id(), sub.plan(), detail + " · " + PlanTree.name(plan));
        });
    }

    private void transition(Plan plan, Transition transition) {
        ElementNames names = new ElementNames(plan, vocabulary);
        add(plan, transition.id(), names.of(transition), "transition · " + PlanTree.name(plan));
        transition.inputs().forEach(event -> {
            StringBuilder detail = new StringBuilder(label(event.type()));
            event.fields()
                    .forEach((field, value) ->
                            detail.append(", ").append(field).append(" = ").append(words(value)));
            add(plan, transition.id(), event.type(), rest(detail, event.writes(), event.markups(), plan));
        });
    }

    private void edge(Plan plan, InEdge edge) {
        edge.requirements()
                .forEach(r -> add(plan, edge.id(), RequirementWords.of(r), "in requirement · " + PlanTree.name(plan)));
    }

    private void edge(Plan plan, OutEdge edge) {
        edge.requirements()
                .forEach(r -> add(plan, edge.id(), RequirementWords.of(r), "out requirement · " + PlanTree.name(plan)));
    }

    private static String rest(StringBuilder detail, Map<String, String> writes, List<MarkupSpec> markups, Plan plan) {
        writes.forEach((field, variable) ->
                detail.append(", ").append(field).append(" into ").append(variable));
        markups.forEach(markup -> {
            detail.append(", ").append(markup.type());
            markup.options().values().forEach(value -> detail.append(' ').append(words(value)));
        });
        return detail.append(" · ").append(PlanTree.name(plan)).toString();
    }

    private String label(String type) {
        return vocabulary.title(type);
    }

    private static String words(FieldSource source) {
        if (source instanceof FieldSource.Fixed fixed) {
            return words(fixed.value());
        }
        if (source instanceof FieldSource.FromVariable from) {
            return from.variable();
        }
        return source instanceof FieldSource.FromTask ? "@task" : "asked at the start";
    }

    private static String words(Value value) {
        return ValueSummary.of(value);
    }

    private void variables(String plan, List<VariableSpec> variables) {
        variables.forEach(v -> {
            String initial = v.initial().map(value -> " = " + words(value)).orElse("");
            all.add(new Hit(
                    plan,
                    "",
                    v.name(),
                    "variable " + TypeNames.of(v.type()) + initial
                            + (plan.isEmpty() ? " of the project" : " · " + plan)));
        });
    }

    private void add(Plan plan, String element, String title, String detail) {
        all.add(new Hit(plan.id(), element, title, detail));
    }
}
