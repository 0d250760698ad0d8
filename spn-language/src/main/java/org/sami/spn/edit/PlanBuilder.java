package org.sami.spn.edit;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.UnaryOperator;
import org.sami.spn.model.FieldSource;
import org.sami.spn.model.InEdge;
import org.sami.spn.model.InRequirement;
import org.sami.spn.model.InputEventSpec;
import org.sami.spn.model.LayoutPoint;
import org.sami.spn.model.MarkupSpec;
import org.sami.spn.model.Mode;
import org.sami.spn.model.Note;
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
import org.sami.spn.model.WaitFor;
import org.sami.spn.value.Value;

/**
 * Builds a plan in a few lines. Vertices come in the order in which they are first named, edges in the order in which they are drawn.
 * Events get the id {@code vertex.Type}, with a number from 2 where that is taken; edges {@code i0}, {@code i1}, … into transitions and
 * {@code o0}, {@code o1}, … out of them; sub-missions {@code place.sub0}, …. A builder adds only; what exists is changed by edits.
 */
public final class PlanBuilder {
    private final Map<String, Place> places = new LinkedHashMap<>();
    private final Map<String, Transition> transitions = new LinkedHashMap<>();
    private final List<InEdge> inEdges = new ArrayList<>();
    private final List<OutEdge> outEdges = new ArrayList<>();
    private final List<VariableSpec> variables = new ArrayList<>();
    private final List<String> reads = new ArrayList<>();
    private final List<TaskSpec> tasks = new ArrayList<>();
    private final List<Note> notes = new ArrayList<>();
    private final List<TestCase> testCases = new ArrayList<>();
    private final Map<String, LayoutPoint> layout = new LinkedHashMap<>();
    private final Set<String> eventIds = new HashSet<>();
    private final String id;
    private String name;
    private String description = "";

    /** A plan without anything, whose name is its id. */
    public PlanBuilder(String id) {
        this.id = id;
        this.name = id;
    }

    /** Its name for people. */
    public PlanBuilder named(String planName) {
        name = planName;
        return this;
    }

    /** A few sentences for those who choose a plan. */
    public PlanBuilder describedAs(String sentences) {
        description = sentences;
        return this;
    }

    /** The start place. */
    public PlanBuilder start(String place) {
        return place(place, p -> p.withStart(true));
    }

    /** Ordinary places. */
    public PlanBuilder places(String... ids) {
        Arrays.stream(ids).forEach(p -> place(p, UnaryOperator.identity()));
        return this;
    }

    /** End places. */
    public PlanBuilder end(String... ids) {
        Arrays.stream(ids).forEach(p -> place(p, place -> place.withEnd(true)));
        return this;
    }

    /** An end place that ends the shared instance. */
    public PlanBuilder endShared(String place) {
        return place(place, p -> p.withEnd(true).withEndsSharedInstance(true));
    }

    /** A vertex's name for people; without one its name is its id. The vertex has been named before. */
    public PlanBuilder name(String vertex, String vertexName) {
        return places.containsKey(vertex)
                ? place(vertex, p -> p.withName(vertexName))
                : transition(vertex, t -> t.withName(vertexName));
    }

    /** Vertices that are shown in recovery mode alone; they have been named before. */
    public PlanBuilder recovery(String... vertices) {
        for (String vertex : vertices) {
            if (places.containsKey(vertex)) {
                place(vertex, p -> p.withMode(Mode.RECOVERY));
            } else {
                transition(vertex, t -> t.withMode(Mode.RECOVERY));
            }
        }
        return this;
    }

    /** Where a vertex is drawn. */
    public PlanBuilder at(String vertex, double x, double y) {
        layout.put(vertex, new LayoutPoint(x, y));
        return this;
    }

    /** An output event without fields. */
    public PlanBuilder output(String place, String type, MarkupSpec... markups) {
        return output(place, type, Map.of(), Map.of(), markups);
    }

    /** An output event with sources of fields and variables that they write. */
    public PlanBuilder output(
            String place,
            String type,
            Map<String, FieldSource> fields,
            Map<String, String> writes,
            MarkupSpec... markups) {
        OutputEventSpec event = new OutputEventSpec(eventId(place, type), type, fields, writes, List.of(markups));
        return place(place, p -> p.withOutputs(Parts.with(p.outputs(), event)));
    }

    /** A dynamic sub-mission. */
    public PlanBuilder sub(String place, String plan) {
        return sub(place, plan, false, Map.of(), Map.of());
    }

    /** A static sub-mission. */
    public PlanBuilder shared(String place, String plan) {
        return sub(place, plan, true, Map.of(), Map.of());
    }

    /** A sub-mission with its mappings. */
    public PlanBuilder sub(
            String place, String plan, boolean shared, Map<String, String> taskMap, Map<String, String> variableMap) {
        return place(
                place,
                p -> p.withSubMissions(Parts.with(
                        p.subMissions(),
                        new SubMissionSpec(
                                place + ".sub" + p.subMissions().size(), plan, shared, taskMap, variableMap))));
    }

    /** The order in which a place's out-transitions are looked at. */
    public PlanBuilder order(String place, String... transitionIds) {
        return place(place, p -> p.withTransitionOrder(List.of(transitionIds)));
    }

    /** A transition with input events by type. */
    public PlanBuilder transition(String transition, String... inputs) {
        transition(transition, UnaryOperator.identity());
        Arrays.stream(inputs).forEach(i -> input(transition, i, Map.of(), Map.of()));
        return this;
    }

    /** An input event with fixed fields and writes. */
    public PlanBuilder input(String transition, String type, Map<String, Value> fields, Map<String, String> writes) {
        InputEventSpec event = new InputEventSpec(eventId(transition, type), type, fields, writes, List.of());
        return transition(transition, t -> t.withInputs(Parts.with(t.inputs(), event)));
    }

    /** Lets a transition wait for all. */
    public PlanBuilder waitForAll(String transition) {
        return transition(transition, t -> t.withWaitFor(WaitFor.ALL));
    }

    /** An edge from a place to a transition. */
    public PlanBuilder in(String place, String transition, InRequirement... requirements) {
        places(place);
        transition(transition);
        String edge = "i" + inEdges.size();
        inEdges.add(new InEdge(edge, place, transition, Mode.NOMINAL, List.of(requirements)));
        return this;
    }

    /** An edge from a transition to a place. */
    public PlanBuilder out(String transition, String place, OutRequirement... requirements) {
        places(place);
        transition(transition);
        String edge = "o" + outEdges.size();
        outEdges.add(new OutEdge(edge, transition, place, Mode.NOMINAL, List.of(requirements)));
        return this;
    }

    /** A variable. */
    public PlanBuilder variable(VariableSpec variable) {
        variables.add(variable);
        return this;
    }

    /** Names of variables that are expected of parents or the project. */
    public PlanBuilder reads(String... names) {
        reads.addAll(List.of(names));
        return this;
    }

    /** A task. */
    public PlanBuilder task(TaskSpec task) {
        tasks.add(task);
        return this;
    }

    /** A note about the plan as a whole. */
    public PlanBuilder note(String note) {
        notes.add(Note.of(note));
        return this;
    }

    /** A test case. */
    public PlanBuilder testCase(TestCase testCase) {
        testCases.add(testCase);
        return this;
    }

    /** The plan as it is by now; the builder can go on. */
    public Plan build() {
        return new Plan(
                id,
                name,
                description,
                List.copyOf(places.values()),
                List.copyOf(transitions.values()),
                inEdges,
                outEdges,
                variables,
                reads,
                tasks,
                layout,
                notes,
                testCases);
    }

    private PlanBuilder place(String place, UnaryOperator<Place> change) {
        Place known = places.getOrDefault(
                place, new Place(place, place, false, false, false, Mode.NOMINAL, List.of(), List.of(), List.of()));
        places.put(place, change.apply(known));
        return this;
    }

    private PlanBuilder transition(String transition, UnaryOperator<Transition> change) {
        Transition known = transitions.getOrDefault(
                transition, new Transition(transition, transition, Mode.NOMINAL, WaitFor.EACH, List.of()));
        transitions.put(transition, change.apply(known));
        return this;
    }

    private String eventId(String vertex, String type) {
        String event = Parts.freshId(eventIds, vertex + "." + type);
        eventIds.add(event);
        return event;
    }
}
