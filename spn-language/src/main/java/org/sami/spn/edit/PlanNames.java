package org.sami.spn.edit;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import java.util.function.Function;
import org.sami.spn.model.FieldSource;
import org.sami.spn.model.InEdge;
import org.sami.spn.model.InRequirement;
import org.sami.spn.model.InputEventSpec;
import org.sami.spn.model.LayoutPoint;
import org.sami.spn.model.MarkupSpec;
import org.sami.spn.model.OutEdge;
import org.sami.spn.model.OutRequirement;
import org.sami.spn.model.OutputEventSpec;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;
import org.sami.spn.model.SubMissionSpec;
import org.sami.spn.model.TaskSpec;
import org.sami.spn.model.TestCase;
import org.sami.spn.model.Transition;
import org.sami.spn.model.VariableSpec;
import org.sami.spn.value.Value;

/** Goes through every name in a plan, in the order of the document, and lets each be another: for renaming, copying and finding. */
final class PlanNames {
    private final Plan plan;
    private final Function<NameUse, String> names;

    private PlanNames(Plan plan, Function<NameUse, String> names) {
        this.plan = plan;
        this.names = names;
    }

    /** The plan with other names; its own id stays. */
    static Plan replaced(Plan plan, Function<NameUse, String> names) {
        return new PlanNames(plan, names).replaced();
    }

    /** Tells every use of a name. */
    static void forEach(Plan plan, Consumer<NameUse> each) {
        replaced(plan, use -> {
            each.accept(use);
            return use.name();
        });
    }

    private Plan replaced() {
        List<VariableSpec> variables = plan.variables().stream()
                .map(v -> v.withName(variable(v.name(), v.name(), "declaration"))
                        .withInitial(v.initial().map(value -> value(value, v.name(), "first value"))))
                .toList();
        List<String> reads = plan.reads().stream()
                .map(r -> variable(r, "", "variables expected of parents"))
                .toList();
        List<TaskSpec> tasks = plan.tasks().stream()
                .map(t -> t.withName(name(NameUse.Kind.TASK, t.name(), plan.id(), t.name(), "declaration"))
                        .withFields(values(t.fields(), t.name(), "field ")))
                .toList();
        Map<String, LayoutPoint> layout = new LinkedHashMap<>();
        List<Place> places = plan.places().stream().map(this::place).toList();
        List<Transition> transitions =
                plan.transitions().stream().map(this::transition).toList();
        List<InEdge> inEdges = plan.inEdges().stream().map(this::in).toList();
        List<OutEdge> outEdges = plan.outEdges().stream().map(this::out).toList();
        plan.layout().forEach((vertex, at) -> layout.put(element(vertex, vertex, "layout"), at));
        List<TestCase> cases = new TestCaseNames(plan, names).replaced();
        return plan.withVariables(variables)
                .withReads(reads)
                .withTasks(tasks)
                .withPlaces(places)
                .withTransitions(transitions)
                .withInEdges(inEdges)
                .withOutEdges(outEdges)
                .withLayout(layout)
                .withTestCases(cases)
                .withQueries(new QueryNames(plan, names).replaced());
    }

    private String name(NameUse.Kind kind, String name, String of, String element, String where) {
        return names.apply(new NameUse(kind, name, of, element, where));
    }

    private String element(String id, String in, String where) {
        return name(NameUse.Kind.ELEMENT, id, plan.id(), in, where);
    }

    private String itself(String id) {
        return element(id, id, NameUse.ITSELF);
    }

    private String variable(String name, String in, String where) {
        return name(NameUse.Kind.VARIABLE, name, plan.id(), in, where);
    }

    private Place place(Place p) {
        return p.withId(itself(p.id()))
                .withOutputs(p.outputs().stream().map(this::output).toList())
                .withSubMissions(p.subMissions().stream().map(this::subMission).toList())
                .withTransitionOrder(p.transitionOrder().stream()
                        .map(t -> element(t, p.id(), "order of transitions"))
                        .toList());
    }

    private Transition transition(Transition t) {
        return t.withId(itself(t.id()))
                .withInputs(t.inputs().stream().map(this::input).toList());
    }

    private OutputEventSpec output(OutputEventSpec o) {
        name(NameUse.Kind.EVENT_TYPE, o.type(), "", o.id(), "output event");
        Map<String, FieldSource> fields = new LinkedHashMap<>();
        o.fields().forEach((field, source) -> fields.put(field, source(source, field, o.id())));
        return o.withId(itself(o.id()))
                .withFields(fields)
                .withWrites(writes(o.writes(), o.id()))
                .withMarkups(markups(o.markups(), o.id()));
    }

    private FieldSource source(FieldSource source, String field, String event) {
        if (source instanceof FieldSource.FromVariable from) {
            return new FieldSource.FromVariable(variable(from.variable(), event, "field " + field));
        }
        if (source instanceof FieldSource.Fixed fixed) {
            return new FieldSource.Fixed(fieldValue(field, fixed.value(), event));
        }
        return source instanceof FieldSource.Asked asked
                ? new FieldSource.Asked(asked.defaultValue().map(v -> fieldValue(field, v, event)), asked.editable())
                : source;
    }

    private InputEventSpec input(InputEventSpec i) {
        name(NameUse.Kind.EVENT_TYPE, i.type(), "", i.id(), "input event");
        Map<String, Value> fields = new LinkedHashMap<>();
        i.fields().forEach((field, value) -> fields.put(field, fieldValue(field, value, i.id())));
        return i.withId(itself(i.id()))
                .withFields(fields)
                .withWrites(writes(i.writes(), i.id()))
                .withMarkups(markups(i.markups(), i.id()));
    }

    private Value fieldValue(String field, Value value, String event) {
        return new ValueNames(plan.id(), names).field(field, value, event, "field " + field);
    }

    private Value value(Value value, String element, String where) {
        return new ValueNames(plan.id(), names).value(value, element, where);
    }

    private Map<String, Value> values(Map<String, Value> values, String element, String where) {
        Map<String, Value> replaced = new LinkedHashMap<>();
        values.forEach((key, value) -> replaced.put(key, value(value, element, where + key)));
        return replaced;
    }

    private Map<String, String> writes(Map<String, String> writes, String event) {
        Map<String, String> replaced = new LinkedHashMap<>();
        writes.forEach((field, variable) -> replaced.put(field, variable(variable, event, "written from " + field)));
        return replaced;
    }

    private List<MarkupSpec> markups(List<MarkupSpec> markups, String event) {
        List<MarkupSpec> replaced = new ArrayList<>();
        markups.forEach(m ->
                replaced.add(new MarkupSpec(m.type(), values(m.options(), event, "markup " + m.type() + ", "))));
        return replaced;
    }

    private SubMissionSpec subMission(SubMissionSpec s) {
        Map<String, String> tasks = new LinkedHashMap<>();
        s.tasks()
                .forEach((parent, child) -> tasks.put(
                        name(NameUse.Kind.TASK, parent, plan.id(), s.id(), "task given to a sub-mission"),
                        name(NameUse.Kind.TASK, child, s.plan(), s.id(), "task that a parent gives")));
        Map<String, String> variables = new LinkedHashMap<>();
        s.variables()
                .forEach((child, parent) -> variables.put(
                        name(NameUse.Kind.VARIABLE, child, s.plan(), s.id(), "variable that a parent gives"),
                        variable(parent, s.id(), "variable given to a sub-mission")));
        return new SubMissionSpec(
                itself(s.id()),
                name(NameUse.Kind.PLAN, s.plan(), "", s.id(), "sub-mission"),
                s.shared(),
                tasks,
                variables);
    }

    private InEdge in(InEdge e) {
        return new InEdge(
                itself(e.id()),
                element(e.place(), e.id(), "edge"),
                element(e.transition(), e.id(), "edge"),
                e.mode(),
                e.requirements().stream()
                        .map(r -> new InRequirement(r.kind(), r.match(), r.n(), task(r.task(), e.id())))
                        .toList(),
                e.locked());
    }

    private OutEdge out(OutEdge e) {
        return new OutEdge(
                itself(e.id()),
                element(e.transition(), e.id(), "edge"),
                element(e.place(), e.id(), "edge"),
                e.mode(),
                e.requirements().stream()
                        .map(r -> new OutRequirement(r.kind(), r.n(), r.action(), task(r.task(), e.id())))
                        .toList(),
                e.locked());
    }

    private String task(String task, String edge) {
        return task.isEmpty() ? task : name(NameUse.Kind.TASK, task, plan.id(), edge, "requirement");
    }
}
