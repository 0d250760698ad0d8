package org.sami.spn.analysis;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.sami.spn.analysis.PlanContext.PlacedOutput;
import org.sami.spn.flow.TokenType;
import org.sami.spn.model.FieldSource;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;
import org.sami.spn.model.SubMissionSpec;
import org.sami.spn.model.TaskSpec;
import org.sami.spn.model.VariableSpec;
import org.sami.spn.value.ValueType;
import org.sami.spn.vocabulary.EventRole;
import org.sami.spn.vocabulary.Reserved;

/**
 * All that checks of other plans look at in a plan: where two versions are equal in it, findings about the plans that run it, and that it
 * runs, are the same. A check that looks at more of a neighbour adds it here; {@link LiveChecks} depends on it.
 */
record PlanInterface(
        String title,
        Map<String, ValueType> variables,
        List<String> reads,
        Set<String> readByEvents,
        Set<String> writtenByEvents,
        List<SubMissionSpec> subMissions,
        Set<String> inputTypes,
        boolean ends,
        Optional<String> endsSharedInstance,
        List<Optional<FieldSource>> returned,
        Set<String> tasks,
        Map<String, Set<TokenType>> broughtTokens,
        Set<TokenType> madeTokens) {

    /**
     * Whether tokens go in and out of it as in another version: what one sub-mission brings back can come to a place at which the same parent
     * starts another.
     */
    boolean hasSameFlow(PlanInterface other) {
        return broughtTokens.equals(other.broughtTokens) && madeTokens.equals(other.madeTokens);
    }

    static PlanInterface of(PlanContext context) {
        Plan plan = context.plan();
        Map<String, ValueType> variables = new LinkedHashMap<>();
        for (VariableSpec v : plan.variables()) {
            variables.putIfAbsent(v.name(), v.type());
        }
        Set<String> read = new LinkedHashSet<>();
        context.scope().reads().forEach(use -> read.add(use.variable()));
        Set<String> written = new LinkedHashSet<>();
        context.scope().writes().forEach(use -> written.add(use.variable()));
        Set<String> inputTypes = new LinkedHashSet<>();
        plan.transitions().forEach(t -> t.inputs().forEach(i -> inputTypes.add(i.type())));
        List<Optional<FieldSource>> returned = new ArrayList<>();
        for (PlacedOutput output : context.outputs()) {
            if (output.type().role() == EventRole.RETURN_VALUE) {
                returned.add(Optional.ofNullable(output.spec().fields().get(Reserved.VALUE)));
            }
        }
        Set<String> tasks = new LinkedHashSet<>();
        plan.tasks().stream().map(TaskSpec::name).forEach(tasks::add);
        return new PlanInterface(
                plan.title(),
                variables,
                plan.reads(),
                read,
                written,
                VariableScope.subMissions(plan).toList(),
                inputTypes,
                plan.places().stream().anyMatch(Place::end),
                SharedInstancesOver.ending(plan).map(place -> context.name(place)),
                returned,
                tasks,
                context.flow().brought(),
                context.flow().made());
    }
}
