package org.sami.spn.testing;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.sami.spn.model.FieldSource;
import org.sami.spn.model.InEdge;
import org.sami.spn.model.InputEventSpec;
import org.sami.spn.model.MarkupSpec;
import org.sami.spn.model.Mode;
import org.sami.spn.model.OutEdge;
import org.sami.spn.model.OutputEventSpec;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.model.SubMissionSpec;
import org.sami.spn.model.TaskSpec;
import org.sami.spn.model.Transition;
import org.sami.spn.model.VariableSpec;
import org.sami.spn.model.WaitFor;
import org.sami.spn.value.Value;
import org.sami.spn.value.ValueType;

/**
 * A plan in a few lines. Vertices come in the order in which they are named, edges in the order in which they are drawn;
 * the words of requirements are those of {@link Requirements}. Event ids are {@code vertex.Type}.
 */
public final class NetBuilder {
    private final String id;
    private final Map<String, PlaceDraft> places = new LinkedHashMap<>();
    private final Map<String, TransitionDraft> transitions = new LinkedHashMap<>();
    private final List<InEdge> inEdges = new ArrayList<>();
    private final List<OutEdge> outEdges = new ArrayList<>();
    private final List<VariableSpec> variables = new ArrayList<>();
    private final List<TaskSpec> tasks = new ArrayList<>();

    /** A plan without anything. */
    public NetBuilder(String id) {
        this.id = id;
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
        draft(place).start = true;
        return this;
    }

    /** Ordinary places. */
    public NetBuilder places(String... ids) {
        Arrays.stream(ids).forEach(this::draft);
        return this;
    }

    /** End places. */
    public NetBuilder end(String... ids) {
        Arrays.stream(ids).forEach(p -> draft(p).end = true);
        return this;
    }

    /** An end place that ends the shared instance. */
    public NetBuilder endShared(String place) {
        draft(place).end = true;
        draft(place).endsShared = true;
        return this;
    }

    /** An output event without fields. */
    public NetBuilder output(String place, String type, MarkupSpec... markups) {
        return output(place, type, Map.of(), Map.of(), markups);
    }

    /** An output event with sources of fields and variables that they write. */
    public NetBuilder output(
            String place,
            String type,
            Map<String, FieldSource> fields,
            Map<String, String> writes,
            MarkupSpec... markups) {
        PlaceDraft draft = draft(place);
        String eventId = place + "." + type;
        draft.outputs.add(new OutputEventSpec(eventId, type, fields, writes, List.of(markups)));
        return this;
    }

    /** A dynamic sub-mission. */
    public NetBuilder sub(String place, String plan) {
        return sub(place, plan, false, Map.of(), Map.of());
    }

    /** A static sub-mission. */
    public NetBuilder shared(String place, String plan) {
        return sub(place, plan, true, Map.of(), Map.of());
    }

    /** A sub-mission with its mappings. */
    public NetBuilder sub(
            String place, String plan, boolean shared, Map<String, String> taskMap, Map<String, String> variableMap) {
        PlaceDraft draft = draft(place);
        draft.subMissions.add(
                new SubMissionSpec(place + ".sub" + draft.subMissions.size(), plan, shared, taskMap, variableMap));
        return this;
    }

    /** The order in which a place's out-transitions are looked at. */
    public NetBuilder order(String place, String... transitionIds) {
        draft(place).order = List.of(transitionIds);
        return this;
    }

    /** A transition with input events by type. */
    public NetBuilder transition(String transition, String... inputs) {
        transitionDraft(transition);
        Arrays.stream(inputs).forEach(i -> input(transition, i, Map.of(), Map.of()));
        return this;
    }

    /** An input event with fixed fields and writes. */
    public NetBuilder input(String transition, String type, Map<String, Value> fields, Map<String, String> writes) {
        TransitionDraft draft = transitionDraft(transition);
        draft.inputs.add(new InputEventSpec(
                transition + "." + type + (draft.inputs.isEmpty() ? "" : "." + draft.inputs.size()),
                type,
                fields,
                writes,
                List.of()));
        return this;
    }

    /** Lets a transition wait for all. */
    public NetBuilder waitForAll(String transition) {
        transitionDraft(transition).waitFor = WaitFor.ALL;
        return this;
    }

    /** An edge from a place to a transition. */
    public NetBuilder in(String place, String transition, String... requirements) {
        draft(place);
        transitionDraft(transition);
        inEdges.add(new InEdge(
                "i" + inEdges.size(),
                place,
                transition,
                Mode.NOMINAL,
                Arrays.stream(requirements).map(Requirements::in).toList()));
        return this;
    }

    /** An edge from a transition to a place. */
    public NetBuilder out(String transition, String place, String... requirements) {
        draft(place);
        transitionDraft(transition);
        outEdges.add(new OutEdge(
                "o" + outEdges.size(),
                transition,
                place,
                Mode.NOMINAL,
                Arrays.stream(requirements).map(Requirements::out).toList()));
        return this;
    }

    /** A variable without a value. */
    public NetBuilder variable(String name, ValueType type) {
        variables.add(new VariableSpec(name, type, Optional.empty()));
        return this;
    }

    /** A variable with a value. */
    public NetBuilder variable(String name, ValueType type, Value initial) {
        variables.add(new VariableSpec(name, type, Optional.of(initial)));
        return this;
    }

    /** A task. */
    public NetBuilder task(String name, String taskClass, Map<String, Value> fields) {
        tasks.add(new TaskSpec(name, taskClass, fields));
        return this;
    }

    /** The plan. */
    public Plan build() {
        return new Plan(
                id,
                id,
                "",
                places.values().stream().map(PlaceDraft::build).toList(),
                transitions.values().stream().map(TransitionDraft::build).toList(),
                inEdges,
                outEdges,
                variables,
                List.of(),
                tasks,
                Map.of(),
                List.of(),
                List.of());
    }

    private PlaceDraft draft(String place) {
        return places.computeIfAbsent(place, PlaceDraft::new);
    }

    private TransitionDraft transitionDraft(String transition) {
        return transitions.computeIfAbsent(transition, TransitionDraft::new);
    }

    private static final class PlaceDraft {
        private final String id;
        private boolean start;
        private boolean end;
        private boolean endsShared;
        private final List<OutputEventSpec> outputs = new ArrayList<>();
        private final List<SubMissionSpec> subMissions = new ArrayList<>();
        private List<String> order = List.of();

        PlaceDraft(String id) {
            this.id = id;
        }

        Place build() {
            return new Place(id, id, start, end, endsShared, Mode.NOMINAL, outputs, subMissions, order);
        }
    }

    private static final class TransitionDraft {
        private final String id;
        private WaitFor waitFor = WaitFor.EACH;
        private final List<InputEventSpec> inputs = new ArrayList<>();

        TransitionDraft(String id) {
            this.id = id;
        }

        Transition build() {
            return new Transition(id, id, Mode.NOMINAL, waitFor, inputs);
        }
    }
}
