package org.sami.spn.edit;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.sami.spn.model.InEdge;
import org.sami.spn.model.InRequirement;
import org.sami.spn.model.LayoutPoint;
import org.sami.spn.model.Match;
import org.sami.spn.model.NetFrame;
import org.sami.spn.model.OutEdge;
import org.sami.spn.model.OutRequirement;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;
import org.sami.spn.model.SubMissionSpec;
import org.sami.spn.model.TaskSpec;
import org.sami.spn.model.TokenKind;
import org.sami.spn.model.Transition;
import org.sami.spn.model.VariableSpec;
import org.sami.spn.naming.ElementNames;
import org.sami.spn.value.TypeCheck;
import org.sami.spn.value.ValueType;
import org.sami.spn.vocabulary.TaskClass;
import org.sami.spn.vocabulary.Vocabulary;

/** What the reader would refuse of one plan: ids, edges, requirements, names of variables, tasks, sub-missions. */
final class PlanForm {
    private final Plan plan;
    private final Set<String> planIds;
    private final Vocabulary vocabulary;
    private final ElementNames names;
    private final List<String> problems = new ArrayList<>();
    private final Set<String> ids = new HashSet<>();
    private final Set<String> places = new HashSet<>();
    private final Set<String> transitions = new HashSet<>();

    PlanForm(Plan plan, Set<String> planIds, Vocabulary vocabulary) {
        this.plan = plan;
        this.planIds = planIds;
        this.vocabulary = vocabulary;
        this.names = new ElementNames(plan, vocabulary);
    }

    List<String> problems() {
        EventForm events = new EventForm(vocabulary, this::problem);
        for (Place place : plan.places()) {
            take(place.id());
            places.add(place.id());
            place.outputs().forEach(o -> take(o.id()));
            place.outputs().forEach(events::output);
            place.subMissions().forEach(this::subMission);
        }
        for (Transition t : plan.transitions()) {
            take(t.id());
            transitions.add(t.id());
            t.inputs().forEach(i -> take(i.id()));
            t.inputs().forEach(events::input);
        }
        edges();
        for (Place place : plan.places()) {
            place.transitionOrder().stream()
                    .filter(t -> !transitions.contains(t))
                    .forEach(t ->
                            problem("the place " + place.id() + " orders a transition " + t + " that is not there"));
        }
        plan.layout().forEach(this::layout);
        plan.frames().forEach(this::frame);
        variables(plan.variables(), "the plan \"" + plan.id() + "\"", vocabulary, problems);
        plan.reads().forEach(this::variable);
        tasks();
        return problems;
    }

    private void problem(String what) {
        problems.add("In the plan \"" + plan.id() + "\" " + what);
    }

    private void take(String id) {
        if (id.isEmpty()) {
            problem("an id is empty");
        } else if (!ids.add(id)) {
            problem("the id " + id + " is used already");
        }
    }

    private void edges() {
        Set<String> pairs = new HashSet<>();
        for (InEdge e : plan.inEdges()) {
            edge(e.id(), e.place(), e.transition(), pairs, e.place() + " to " + e.transition());
            e.requirements().forEach(r -> in(e, r));
        }
        for (OutEdge e : plan.outEdges()) {
            edge(e.id(), e.place(), e.transition(), pairs, e.transition() + " to " + e.place());
            e.requirements().forEach(r -> out(e, r));
        }
    }

    private void edge(String id, String place, String transition, Set<String> pairs, String way) {
        take(id);
        if (!places.contains(place) || !transitions.contains(transition)) {
            problem("the edge " + id + " hangs in the air: there is no "
                    + (places.contains(place) ? transition : place));
        }
        if (!pairs.add(way)) {
            problem("the edge " + names.of(id).orElse(way) + " is there already");
        }
    }

    private void in(InEdge e, InRequirement r) {
        boolean counted = r.match() == Match.LESS_THAN || r.match() == Match.AT_LEAST || r.match() == Match.EXACTLY;
        if (r.kind() == TokenKind.UNCONDITIONAL && !r.equals(InRequirement.unconditional())) {
            problem("a requirement of the edge " + e.id() + " is unconditional and asks for something");
        }
        if (r.kind() != TokenKind.UNCONDITIONAL && (counted ? r.n() < 1 : r.n() != 0)) {
            problem("a requirement of the edge " + e.id() + " asks for " + r.n() + " tokens: say 1 or more, or zero");
        }
        task(e.id(), r.kind(), r.task());
    }

    private void out(OutEdge e, OutRequirement r) {
        if (r.kind() == TokenKind.UNCONDITIONAL && !r.equals(OutRequirement.unconditional())) {
            problem("a requirement of the edge " + e.id() + " is unconditional and asks for something");
        }
        if (r.n() == 0) {
            problem("a requirement of the edge " + e.id() + " moves 0 tokens: say 1 or more, or all");
        }
        task(e.id(), r.kind(), r.task());
    }

    private void task(String edge, TokenKind kind, String task) {
        if ((kind == TokenKind.TASK) == task.isEmpty()) {
            problem("a requirement of the edge " + edge + " names a task with the kind task, and only there");
        }
    }

    private void subMission(SubMissionSpec s) {
        take(s.id());
        if (!planIds.contains(s.plan())) {
            problem("the sub-mission " + s.id() + " runs the plan \"" + s.plan() + "\", which is not there");
        }
        s.variables().forEach((child, parent) -> {
            variable(child);
            variable(parent);
        });
    }

    private void layout(String vertex, LayoutPoint at) {
        if (!places.contains(vertex) && !transitions.contains(vertex)) {
            problem("there is no vertex " + vertex + " to lay out");
        }
        if (!Double.isFinite(at.x()) || !Double.isFinite(at.y())) {
            problem("the vertex " + vertex + " lies nowhere: " + at.x() + ", " + at.y());
        }
    }

    private void frame(NetFrame frame) {
        if (!Double.isFinite(frame.at().x())
                || !Double.isFinite(frame.at().y())
                || !Double.isFinite(frame.width())
                || !Double.isFinite(frame.height())) {
            problem("the frame \"" + frame.title() + "\" lies nowhere: "
                    + frame.at().x() + ", " + frame.at().y() + ", " + frame.width() + " by " + frame.height());
        }
    }

    private void variable(String name) {
        VariableNameForm.problem(name).ifPresent(this::problem);
    }

    private void tasks() {
        Set<String> names = new HashSet<>();
        for (TaskSpec task : plan.tasks()) {
            if (task.name().isEmpty() || !names.add(task.name())) {
                problem(task.name().isEmpty() ? "a task has no name" : "there is a task " + task.name() + " already");
            }
            TaskClass taskClass = vocabulary.taskClasses().get(task.taskClass());
            if (taskClass == null) {
                problem("the task " + task.name() + " is of the class " + task.taskClass() + ", which is not there");
            } else {
                EventForm.values(
                        task.fields(), taskClass.fields(), "the task " + task.name(), vocabulary, this::problem);
            }
        }
    }

    static void variables(List<VariableSpec> variables, String owner, Vocabulary vocabulary, List<String> problems) {
        Set<String> names = new HashSet<>();
        for (VariableSpec v : variables) {
            VariableNameForm.problem(v.name()).ifPresent(why -> problems.add("In " + owner + " " + why));
            if (!names.add(v.name())) {
                problems.add("In " + owner + " there is a variable " + v.name() + " already");
            }
            if (!known(v.type(), vocabulary)) {
                problems.add(
                        "In " + owner + " the variable " + v.name() + " is of a type that the domain does not have");
            } else if (v.initial().isPresent()
                    && !TypeCheck.accepts(v.type(), v.initial().get(), vocabulary.types())) {
                problems.add("In " + owner + " the first value of " + v.name() + " is not of its type");
            }
        }
    }

    private static boolean known(ValueType type, Vocabulary vocabulary) {
        if (type instanceof ValueType.ListOf list) {
            return known(list.element(), vocabulary);
        }
        if (type instanceof ValueType.MapOf map) {
            return known(map.key(), vocabulary) && known(map.value(), vocabulary);
        }
        return !(type instanceof ValueType.Named named) || vocabulary.types().containsKey(named.name());
    }
}
