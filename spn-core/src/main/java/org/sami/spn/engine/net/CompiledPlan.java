package org.sami.spn.engine.net;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.sami.spn.model.FieldSource;
import org.sami.spn.model.InEdge;
import org.sami.spn.model.InRequirement;
import org.sami.spn.model.InputEventSpec;
import org.sami.spn.model.OutEdge;
import org.sami.spn.model.OutRequirement;
import org.sami.spn.model.Plan;
import org.sami.spn.model.TokenKind;
import org.sami.spn.model.Transition;
import org.sami.spn.model.VariableSpec;
import org.sami.spn.vocabulary.EventRole;
import org.sami.spn.vocabulary.EventType;

/** One plan in index form. */
public final class CompiledPlan {
    /** A field that is asked when a mission starts. */
    public record AskedField(String key, CompiledOutput output, String field, FieldSource.Asked source) {}

    public final Plan plan;
    /** The project that it is a plan of: its sub-missions and globals are that project's. */
    public final CompiledProject project;

    public final CompiledPlace[] places;
    public final CompiledTransition[] transitions;
    public final @Nullable CompiledPlace start;
    // in the plan's order: the operator is offered them
    public final Map<String, VariableSpec> variables = new LinkedHashMap<>();
    public final List<AskedField> asked = new ArrayList<>();
    /** Input event types of its transitions. */
    public final int[] inputTypes;

    public final boolean hasShared;
    /** Tasks of which it speaks by name: its own, and those of its requirements. */
    public final Set<String> namedTasks = new HashSet<>();

    private final Map<String, CompiledTransition> transitionsById = new HashMap<>();
    private final Map<Integer, CompiledTransition[]> transitionsByType = new HashMap<>();
    private static final CompiledTransition[] NOBODY = {};

    public CompiledPlan(CompiledProject project, Plan plan) {
        this.plan = plan;
        this.project = project;
        Map<String, CompiledPlace> byId = new LinkedHashMap<>();
        for (int i = 0; i < plan.places().size(); i++) {
            byId.put(
                    plan.places().get(i).id(),
                    new CompiledPlace(project.vocabulary, i, plan.places().get(i)));
        }
        places = byId.values().toArray(CompiledPlace[]::new);
        transitions = new CompiledTransition[plan.transitions().size()];
        for (int i = 0; i < transitions.length; i++) {
            transitions[i] = compile(project, i, plan.transitions().get(i), byId);
            transitionsById.put(transitions[i].id(), transitions[i]);
        }
        for (CompiledPlace place : places) {
            link(place);
        }
        start = plan.startPlace().map(p -> byId.get(p.id())).orElse(null);
        plan.variables().forEach(v -> variables.put(v.name(), v));
        collectAsked();
        inputTypes = indexTypes();
        plan.tasks().forEach(t -> namedTasks.add(t.name()));
        plan.inEdges().forEach(e -> e.requirements().forEach(r -> namedTasks.add(r.task())));
        plan.outEdges().forEach(e -> e.requirements().forEach(r -> namedTasks.add(r.task())));
        hasShared = List.of(places).stream().anyMatch(p -> !p.shared.isEmpty());
    }

    /** The transition of that id, or null. */
    public @Nullable CompiledTransition transition(String id) {
        return transitionsById.get(id);
    }

    /** Transitions with an input event of a type, in the plan's order. */
    public CompiledTransition[] waitingFor(int typeId) {
        return transitionsByType.getOrDefault(typeId, NOBODY);
    }

    private CompiledTransition compile(
            CompiledProject project, int index, Transition transition, Map<String, CompiledPlace> places) {
        CompiledInput[] inputs = new CompiledInput[transition.inputs().size()];
        for (int i = 0; i < inputs.length; i++) {
            InputEventSpec spec = transition.inputs().get(i);
            EventRole role =
                    project.vocabulary.event(spec.type()).map(EventType::role).orElse(EventRole.NONE);
            inputs[i] = new CompiledInput(i, spec, project.typeId(spec.type()), role);
        }
        List<CompiledTransition.In> ins = new ArrayList<>();
        for (InEdge edge : plan.inEdgesOf(transition.id())) {
            if (places.containsKey(edge.place())) {
                ins.add(new CompiledTransition.In(
                        places.get(edge.place()), edge.requirements().toArray(InRequirement[]::new)));
            }
        }
        List<CompiledTransition.Out> outs = new ArrayList<>();
        for (OutEdge edge : plan.outEdgesOf(transition.id())) {
            if (places.containsKey(edge.place())) {
                boolean unconditional = edge.requirements().isEmpty()
                        || edge.requirements().stream().anyMatch(r -> r.kind() == TokenKind.UNCONDITIONAL);
                outs.add(new CompiledTransition.Out(
                        places.get(edge.place()), edge.requirements().toArray(OutRequirement[]::new), unconditional));
            }
        }
        return new CompiledTransition(
                index,
                transition,
                inputs,
                ins.toArray(CompiledTransition.In[]::new),
                outs.toArray(CompiledTransition.Out[]::new));
    }

    private void link(CompiledPlace place) {
        Set<CompiledTransition> ordered = new LinkedHashSet<>();
        for (String id : place.place.transitionOrder()) {
            CompiledTransition t = transitionsById.get(id);
            if (t != null && t.hasInPlace(place.index)) {
                ordered.add(t);
            }
        }
        for (InEdge edge : plan.inEdges()) {
            if (edge.place().equals(place.id()) && transitionsById.containsKey(edge.transition())) {
                ordered.add(transitionsById.get(edge.transition()));
            }
        }
        place.outTransitions = ordered.toArray(CompiledTransition[]::new);
        place.barriers =
                ordered.stream().filter(t -> List.of(t.watched).contains(place)).toArray(CompiledTransition[]::new);
        place.answersOutliveVisits = ordered.stream().anyMatch(t -> t.hasInputs() && t.inPlaces.length > 1);
    }

    private void collectAsked() {
        for (CompiledPlace place : places) {
            for (CompiledOutput output : place.outputs) {
                output.resolved.forEach((field, source) -> {
                    if (source instanceof FieldSource.Asked a) {
                        asked.add(new AskedField(output.spec.id() + "." + field, output, field, a));
                    }
                });
            }
        }
    }

    private int[] indexTypes() {
        Map<Integer, List<CompiledTransition>> byType = new LinkedHashMap<>();
        for (CompiledTransition t : transitions) {
            for (CompiledInput input : t.inputs) {
                List<CompiledTransition> list = byType.computeIfAbsent(input.typeId, k -> new ArrayList<>());
                if (!list.contains(t)) {
                    list.add(t);
                }
            }
        }
        byType.forEach((type, list) -> transitionsByType.put(type, list.toArray(CompiledTransition[]::new)));
        return byType.keySet().stream().mapToInt(Integer::intValue).toArray();
    }
}
