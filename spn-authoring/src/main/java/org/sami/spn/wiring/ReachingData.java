package org.sami.spn.wiring;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;
import org.sami.spn.flow.ComingTokens;
import org.sami.spn.flow.TokenType;
import org.sami.spn.model.FieldSource;
import org.sami.spn.model.InputEventSpec;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.model.VariableSpec;
import org.sami.spn.value.TextValue;
import org.sami.spn.value.ValueType;
import org.sami.spn.vocabulary.EventType;
import org.sami.spn.vocabulary.FieldType;
import org.sami.spn.vocabulary.Reserved;
import org.sami.spn.vocabulary.TaskClass;
import org.sami.spn.vocabulary.Vocabulary;

/**
 * What can be read by a field of an output event: the entering task where a task comes that has such a field, then answers and variables of
 * the field's type, nearest first, last those of which nothing before the place says that they have a value.
 */
public final class ReachingData {
    private final Project project;
    private final Plan plan;
    private final Vocabulary vocabulary;
    private final WrittenVariables written;
    private final ComingTokens coming;

    /** The data of a plan of a project. */
    public ReachingData(Project project, Plan plan, Vocabulary vocabulary) {
        this.project = Objects.requireNonNull(project, "project");
        this.plan = Objects.requireNonNull(plan, "plan");
        this.vocabulary = Objects.requireNonNull(vocabulary, "vocabulary");
        this.written = new WrittenVariables(project);
        this.coming = new ComingTokens(project, plan, vocabulary);
    }

    /** What a field of an event that stands on a place can be read from. */
    public List<DataSource> of(String place, FieldType field) {
        List<DataSource> sources = new ArrayList<>();
        if (taskFits(place, field)) {
            sources.add(new DataSource.EnteringTask(field.name()));
        }
        WaysBack ways = new WaysBack(plan, place);
        Map<String, DataSource> found = new LinkedHashMap<>();
        answers(ways, field.type(), found);
        variables(ways, field.type(), found);
        found.values().stream()
                .sorted(Comparator.comparing((DataSource s) -> !s.reaches())
                        .thenComparingInt(DataSource::steps)
                        .thenComparing(s -> !named(s, field.name())))
                .forEach(sources::add);
        return sources;
    }

    /** Of two equally near ones, the one that is called as the field comes first. */
    private static boolean named(DataSource source, String field) {
        return source instanceof DataSource.AnswerField answer
                ? answer.field().equals(field)
                : source instanceof DataSource.Variable variable
                        && variable.name().equals("@" + field);
    }

    // ---- @task

    /** Whether a task can come to a place, and a class of tasks that can has the field with its type (thesis 9.3.4). */
    public boolean taskFits(String place, FieldType field) {
        return coming.comes(TokenType.TASK, place)
                && classes()
                        .anyMatch(c -> c.fields().stream()
                                .anyMatch(f -> f.name().equals(field.name())
                                        && f.type().equals(field.type())));
    }

    /** The classes of the tasks that the plan has and makes; all where it does not say, as where a parent brings them. */
    private Stream<TaskClass> classes() {
        Set<String> names = new LinkedHashSet<>();
        plan.tasks().forEach(t -> names.add(t.taskClass()));
        for (FieldSource made : plan.places().stream()
                .flatMap(p -> p.outputs().stream())
                .flatMap(o -> Optional.ofNullable(o.fields().get(Reserved.TASK_CLASS)).stream())
                .toList()) {
            if (made instanceof FieldSource.Fixed fixed && fixed.value() instanceof TextValue text) {
                names.add(text.value());
            }
        }
        List<TaskClass> known = vocabulary.taskClasses().values().stream()
                .filter(c -> names.contains(c.name()))
                .toList();
        return known.isEmpty() ? vocabulary.taskClasses().values().stream() : known.stream();
    }

    // ---- Answers and variables

    private void answers(WaysBack ways, ValueType type, Map<String, DataSource> found) {
        ways.transitions()
                .forEach((id, steps) -> plan.transition(id)
                        .ifPresent(transition -> transition
                                .inputs()
                                .forEach(input -> vocabulary
                                        .event(input.type())
                                        .ifPresent(known -> answer(input, known, type, id, steps, found)))));
    }

    private void answer(
            InputEventSpec input,
            EventType known,
            ValueType type,
            String transition,
            int steps,
            Map<String, DataSource> found) {
        for (FieldType field : known.fields()) {
            Optional<String> into = Optional.ofNullable(input.writes().get(field.name()));
            boolean other = into.flatMap(v -> written.type(plan, v))
                    .filter(declared -> !declared.equals(type))
                    .isPresent();
            if (field.type().equals(type) && !other) {
                found.putIfAbsent(
                        into.orElse(input.id() + " " + field.name()),
                        new DataSource.AnswerField(input.id(), known.name(), field.name(), transition, into, steps));
            }
        }
    }

    private void variables(WaysBack ways, ValueType type, Map<String, DataSource> found) {
        Map<String, Integer> writers = new HashMap<>();
        ways.transitions()
                .forEach((id, steps) -> plan.transition(id)
                        .ifPresent(t -> written.by(t).forEach(v -> writers.merge(v, steps, Math::min))));
        ways.places()
                .forEach((id, steps) -> plan.place(id)
                        .filter(p -> steps > 0)
                        .ifPresent(p -> written.by(p).forEach(v -> writers.merge(v, steps, Math::min))));
        for (String name : names(writers.keySet())) {
            boolean fits = written.type(plan, name)
                    .map(type::equals)
                    .orElseGet(() -> plan.reads()
                            .contains(name)); // of what parents bring without a declaration no type is known
            if (fits) {
                found.putIfAbsent(name, variable(name, Optional.ofNullable(writers.get(name))));
            }
        }
    }

    private Set<String> names(Set<String> writtenBefore) {
        Set<String> names = new LinkedHashSet<>(writtenBefore);
        plan.variables().forEach(v -> names.add(v.name()));
        names.addAll(plan.reads());
        project.globals().forEach(v -> names.add(v.name()));
        return names;
    }

    private DataSource variable(String name, Optional<Integer> steps) {
        if (steps.isPresent()) {
            return new DataSource.Variable(name, DataSource.Origin.WRITTEN_BEFORE, steps.get());
        }
        DataSource.Origin origin = hasFirstValue(name)
                ? DataSource.Origin.FIRST_VALUE
                : plan.reads().contains(name) || isOfProjectAlone(name)
                        ? DataSource.Origin.PARENT
                        : DataSource.Origin.NOTHING_BEFORE;
        return new DataSource.Variable(name, origin, DataSource.FAR);
    }

    private boolean hasFirstValue(String name) {
        return Stream.concat(plan.variables().stream(), project.globals().stream())
                .filter(v -> v.name().equals(name))
                .findFirst()
                .flatMap(VariableSpec::initial)
                .isPresent();
    }

    private boolean isOfProjectAlone(String name) {
        return plan.variables().stream().noneMatch(v -> v.name().equals(name));
    }
}
