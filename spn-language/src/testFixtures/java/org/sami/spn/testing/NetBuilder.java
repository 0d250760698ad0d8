package org.sami.spn.testing;

import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.sami.spn.edit.PlanBuilder;
import org.sami.spn.model.FieldSource;
import org.sami.spn.model.InRequirement;
import org.sami.spn.model.MarkupSpec;
import org.sami.spn.model.OutRequirement;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.model.TaskSpec;
import org.sami.spn.model.VariableSpec;
import org.sami.spn.value.Value;
import org.sami.spn.value.ValueType;

/** The builder of plans with requirements in the words of {@link Requirements}. */
public final class NetBuilder {
    private final PlanBuilder plan;

    /** A plan without anything. */
    public NetBuilder(String id) {
        plan = new PlanBuilder(id);
    }

    /** A project of plans, without globals. */
    public static Project project(Plan... plans) {
        return project(List.of(), plans);
    }

    /** A project of plans with global variables. */
    public static Project project(List<VariableSpec> globals, Plan... plans) {
        return new Project("test", "Test", "test", globals, List.of(), Arrays.asList(plans));
    }

    /** The start place. */
    public NetBuilder start(String place) {
        plan.start(place);
        return this;
    }

    /** Ordinary places. */
    public NetBuilder places(String... ids) {
        plan.places(ids);
        return this;
    }

    /** End places. */
    public NetBuilder end(String... ids) {
        plan.end(ids);
        return this;
    }

    /** An end place that ends the shared instance. */
    public NetBuilder endShared(String place) {
        plan.endShared(place);
        return this;
    }

    /** An output event without fields. */
    public NetBuilder output(String place, String type, MarkupSpec... markups) {
        plan.output(place, type, markups);
        return this;
    }

    /** An output event with sources of fields and variables that they write. */
    public NetBuilder output(
            String place,
            String type,
            Map<String, FieldSource> fields,
            Map<String, String> writes,
            MarkupSpec... markups) {
        plan.output(place, type, fields, writes, markups);
        return this;
    }

    /** A dynamic sub-mission. */
    public NetBuilder sub(String place, String child) {
        plan.sub(place, child);
        return this;
    }

    /** A static sub-mission. */
    public NetBuilder shared(String place, String child) {
        plan.shared(place, child);
        return this;
    }

    /** A sub-mission with its mappings. */
    public NetBuilder sub(
            String place, String child, boolean shared, Map<String, String> taskMap, Map<String, String> variableMap) {
        plan.sub(place, child, shared, taskMap, variableMap);
        return this;
    }

    /** The order in which a place's out-transitions are looked at. */
    public NetBuilder order(String place, String... transitionIds) {
        plan.order(place, transitionIds);
        return this;
    }

    /** A transition with input events by type. */
    public NetBuilder transition(String transition, String... inputs) {
        plan.transition(transition, inputs);
        return this;
    }

    /** An input event with fixed fields and writes. */
    public NetBuilder input(String transition, String type, Map<String, Value> fields, Map<String, String> writes) {
        plan.input(transition, type, fields, writes);
        return this;
    }

    /** Lets a transition wait for all. */
    public NetBuilder waitForAll(String transition) {
        plan.waitForAll(transition);
        return this;
    }

    /** An edge from a place to a transition. */
    public NetBuilder in(String place, String transition, String... requirements) {
        plan.in(
                place,
                transition,
                Arrays.stream(requirements).map(Requirements::in).toArray(InRequirement[]::new));
        return this;
    }

    /** An edge from a transition to a place. */
    public NetBuilder out(String transition, String place, String... requirements) {
        plan.out(
                transition,
                place,
                Arrays.stream(requirements).map(Requirements::out).toArray(OutRequirement[]::new));
        return this;
    }

    /** A variable without a value. */
    public NetBuilder variable(String name, ValueType type) {
        plan.variable(new VariableSpec(name, type, Optional.empty()));
        return this;
    }

    /** A variable with a value. */
    public NetBuilder variable(String name, ValueType type, Value initial) {
        plan.variable(new VariableSpec(name, type, Optional.of(initial)));
        return this;
    }

    /** Names of variables that are expected of parents or the project. */
    public NetBuilder reads(String... names) {
        plan.reads(names);
        return this;
    }

    /** A task. */
    public NetBuilder task(String name, String taskClass, Map<String, Value> fields) {
        plan.task(new TaskSpec(name, taskClass, fields));
        return this;
    }

    /** The plan. */
    public Plan build() {
        return plan.build();
    }
}
