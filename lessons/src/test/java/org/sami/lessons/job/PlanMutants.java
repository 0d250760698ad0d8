package org.sami.lessons.job;

import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.function.BiConsumer;
import java.util.stream.Stream;
import org.sami.spn.model.Action;
import org.sami.spn.model.FieldSource;
import org.sami.spn.model.InEdge;
import org.sami.spn.model.InRequirement;
import org.sami.spn.model.Match;
import org.sami.spn.model.OutEdge;
import org.sami.spn.model.OutRequirement;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;
import org.sami.spn.model.TokenKind;
import org.sami.spn.model.Transition;
import org.sami.spn.model.VariableSpec;
import org.sami.spn.model.WaitFor;

/**
 * The errors of a careless author in a right plan, one a mutant: another kind, match or quantity of a requirement, an edge or event missing, the
 * wrong variable, an edge that leads elsewhere, the end or the start in another place, another rule of waiting.
 */
final class PlanMutants {
    private static final List<TokenKind> KINDS = List.of(
            TokenKind.GENERIC, TokenKind.ANY_PROXY, TokenKind.ANY_TASK, TokenKind.ANY_TOKEN, TokenKind.RELEVANT);

    private final Plan plan;
    private final List<Mutant> mutants = new ArrayList<>();

    /** One plan with one error. */
    record Mutant(String error, Plan plan) {}

    private PlanMutants(Plan plan) {
        this.plan = plan;
    }

    /**
     * Mutants of a plan, in an order drawn by a seed.
     *
     * @param most how many
     */
    static List<Mutant> of(Plan plan, long seed, int most) {
        PlanMutants all = new PlanMutants(plan);
        all.inEdges();
        all.outEdges();
        all.places();
        all.transitions();
        List<Mutant> drawn = new ArrayList<>(all.mutants);
        Collections.shuffle(drawn, new Random(seed));
        return drawn.subList(0, Math.min(most, drawn.size()));
    }

    private void add(String error, Plan mutated) {
        mutants.add(new Mutant(error, mutated));
    }

    private static <T> List<T> replaced(List<T> list, int at, List<T> by) {
        return Stream.of(list.subList(0, at), by, list.subList(at + 1, list.size()))
                .flatMap(List::stream)
                .toList();
    }

    // ---- Edges

    private void inEdges() {
        for (int i = 0; i < plan.inEdges().size(); i++) {
            int at = i;
            InEdge edge = plan.inEdges().get(i);
            BiConsumer<String, List<InEdge>> change = (error, by) ->
                    add("edge " + edge.id() + ": " + error, plan.withInEdges(replaced(plan.inEdges(), at, by)));
            change.accept("missing", List.of());
            for (int j = 0; j < edge.requirements().size(); j++) {
                InRequirement before = edge.requirements().get(j);
                for (InRequirement after : others(before)) {
                    change.accept(
                            before + " is " + after,
                            List.of(edge.withRequirements(replaced(edge.requirements(), j, List.of(after)))));
                }
            }
        }
    }

    private static List<InRequirement> others(InRequirement before) {
        List<InRequirement> others = new ArrayList<>();
        if (before.kind() == TokenKind.UNCONDITIONAL || before.kind() == TokenKind.TASK) {
            return others;
        }
        for (TokenKind kind : KINDS) {
            if (kind != before.kind()) {
                boolean all = before.match() == Match.ALL;
                others.add(
                        all
                                ? InRequirement.of(kind, Match.AT_LEAST, 1)
                                : new InRequirement(kind, before.match(), before.n(), ""));
            }
        }
        if (before.match() != Match.ZERO) {
            others.add(InRequirement.of(before.kind(), Match.ZERO, 0));
        }
        others.add(InRequirement.of(before.kind(), Match.AT_LEAST, before.n() + 1));
        others.add(InRequirement.of(before.kind(), Match.EXACTLY, before.n() + 2));
        return others;
    }

    private void outEdges() {
        for (int i = 0; i < plan.outEdges().size(); i++) {
            int at = i;
            OutEdge edge = plan.outEdges().get(i);
            BiConsumer<String, List<OutEdge>> change = (error, by) ->
                    add("edge " + edge.id() + ": " + error, plan.withOutEdges(replaced(plan.outEdges(), at, by)));
            change.accept("missing", List.of());
            plan.places().stream()
                    .filter(place -> !place.id().equals(edge.place()))
                    .forEach(place -> change.accept("leads to " + place.id(), List.of(edge.withPlace(place.id()))));
            for (int j = 0; j < edge.requirements().size(); j++) {
                OutRequirement before = edge.requirements().get(j);
                for (OutRequirement after : others(before)) {
                    change.accept(
                            before + " is " + after,
                            List.of(edge.withRequirements(replaced(edge.requirements(), j, List.of(after)))));
                }
            }
        }
    }

    private static List<OutRequirement> others(OutRequirement before) {
        List<OutRequirement> others = new ArrayList<>();
        if (before.kind() == TokenKind.UNCONDITIONAL || !before.task().isEmpty()) {
            return others;
        }
        int other = before.takesAll() ? 1 : OutRequirement.ALL;
        others.add(OutRequirement.of(before.action(), other, before.kind()));
        for (Action action : Action.values()) {
            if (action != before.action()) {
                others.add(OutRequirement.of(action, before.n(), before.kind()));
            }
        }
        for (TokenKind kind : KINDS) {
            if (kind != before.kind()) {
                others.add(OutRequirement.of(before.action(), before.n(), kind));
            }
        }
        return others;
    }

    // ---- Vertices

    private void places() {
        for (int i = 0; i < plan.places().size(); i++) {
            int at = i;
            Place place = plan.places().get(i);
            BiConsumer<String, Place> change = (error, by) -> add(
                    "place " + place.id() + ": " + error, plan.withPlaces(replaced(plan.places(), at, List.of(by))));
            change.accept(place.end() ? "is no end" : "is an end", place.withEnd(!place.end()));
            if (!place.start() && !place.end()) {
                add(
                        "place " + place.id() + ": is the start",
                        plan.withPlaces(plan.places().stream()
                                .map(one -> one.withStart(one.id().equals(place.id())))
                                .toList()));
            }
            for (int j = 0; j < place.outputs().size(); j++) {
                var output = place.outputs().get(j);
                change.accept("without " + output.type(), place.withOutputs(replaced(place.outputs(), j, List.of())));
                int event = j;
                output.fields().forEach((field, source) -> {
                    if (source instanceof FieldSource.FromVariable from) {
                        for (VariableSpec variable : plan.variables()) {
                            if (!variable.name().equals(from.variable())) {
                                Map<String, FieldSource> fields = new LinkedHashMap<>(output.fields());
                                fields.put(field, new FieldSource.FromVariable(variable.name()));
                                change.accept(
                                        field + " reads " + variable.name(),
                                        place.withOutputs(
                                                replaced(place.outputs(), event, List.of(output.withFields(fields)))));
                            }
                        }
                    }
                });
            }
        }
    }

    private void transitions() {
        for (int i = 0; i < plan.transitions().size(); i++) {
            int at = i;
            Transition transition = plan.transitions().get(i);
            BiConsumer<String, Transition> change = (error, by) -> add(
                    "transition " + transition.id() + ": " + error,
                    plan.withTransitions(replaced(plan.transitions(), at, List.of(by))));
            if (!transition.inputs().isEmpty()) {
                WaitFor other = transition.waitFor() == WaitFor.EACH ? WaitFor.ALL : WaitFor.EACH;
                change.accept("waits for " + other, transition.withWaitFor(other));
            }
            for (int j = 0; j < transition.inputs().size(); j++) {
                var input = transition.inputs().get(j);
                change.accept(
                        "without " + input.type(), transition.withInputs(replaced(transition.inputs(), j, List.of())));
                if (!input.writes().isEmpty()) {
                    change.accept(
                            "writes nothing",
                            transition.withInputs(
                                    replaced(transition.inputs(), j, List.of(input.withWrites(Map.of())))));
                }
            }
        }
    }
}
