package org.sami.spn.analysis;

import java.util.ArrayDeque;
import java.util.BitSet;
import java.util.Deque;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import org.sami.spn.analysis.PlanContext.PlacedOutput;
import org.sami.spn.finding.Advice;
import org.sami.spn.finding.Finding;
import org.sami.spn.model.FieldSource;
import org.sami.spn.model.InEdge;
import org.sami.spn.model.Match;
import org.sami.spn.model.OutputEventSpec;
import org.sami.spn.model.Place;
import org.sami.spn.model.TokenKind;
import org.sami.spn.model.Transition;
import org.sami.spn.model.VariableSpec;
import org.sami.spn.vocabulary.EventRole;
import org.sami.spn.vocabulary.FieldType;

/**
 * A variable that a field needs is written on each way that leads to the field's place: nothing applies an allocation that nobody chose.
 * A transition comes after what has been written before any place whose tokens it needs; of a transition without places before it nothing
 * is assumed.
 */
final class ReadsBeforeWrites implements PlanCheck {
    @Override
    public List<Advice> advice() {
        return List.of(new Advice(
                "W-NOT-YET-WRITTEN",
                "On one way to the place the variable has no value yet: the event fails there.",
                "Let each way to the place pass the answer that writes the variable."));
    }

    @Override
    public void check(PlanContext plan, Consumer<Finding> report) {
        List<String> variables = plan.plan().variables().stream()
                .filter(v -> v.initial().isEmpty())
                .map(VariableSpec::name)
                .distinct()
                .filter(v -> !VariableScope.mappedAbove(plan, v))
                .filter(v -> isRead(plan, v) && isWritten(plan, v))
                .toList();
        if (!variables.isEmpty()) {
            Ways ways = new Ways(plan, variables);
            for (PlacedOutput output : plan.outputs()) {
                output.spec().fields().forEach((field, source) -> {
                    if (source instanceof FieldSource.FromVariable from && needs(output, field)) {
                        int index = variables.indexOf(from.variable());
                        if (index >= 0 && ways.lacks(output.place(), index)) {
                            report(plan, output, field, from.variable(), report);
                        }
                    }
                });
            }
        }
    }

    private static boolean needs(PlacedOutput output, String field) {
        return output.type().role() == EventRole.APPLY_ALLOCATION
                || output.type().field(field).filter(FieldType::required).isPresent();
    }

    private static boolean isRead(PlanContext plan, String variable) {
        return plan.scope().reads().stream().anyMatch(use -> use.variable().equals(variable));
    }

    private static boolean isWritten(PlanContext plan, String variable) {
        return VariableScope.writtenBelow(plan, variable, new HashSet<>());
    }

    private static void report(
            PlanContext plan, PlacedOutput output, String field, String variable, Consumer<Finding> report) {
        Set<String> writers = new TreeSet<>();
        for (Transition t : plan.plan().transitions()) {
            if (t.inputs().stream().anyMatch(i -> i.writes().containsValue(variable))) {
                writers.add("the " + plan.name(t));
            }
        }
        String where = writers.isEmpty() ? "" : "; it is written by " + String.join(" and ", writers);
        report.accept(Finding.warning(
                "W-NOT-YET-WRITTEN",
                output.pointer() + "/fields/" + field,
                plan.name(output) + " reads " + variable
                        + ", and a way leads there on which nobody has given it a value" + where
                        + ": let each way pass what writes it",
                output.place().id(),
                output.spec().id(),
                variable));
    }

    /** What has been written on each way to each place: the greatest solution, found by taking away until nothing changes. */
    private static final class Ways {
        private final PlanContext plan;
        private final List<String> variables;
        private final Map<String, BitSet> at = new HashMap<>();
        private final Map<String, BitSet> askedAt;

        Ways(PlanContext plan, List<String> variables) {
            this.plan = plan;
            this.variables = variables;
            askedAt = plan.plan().places().stream()
                    .collect(Collectors.toMap(Place::id, this::whileStanding, (a, b) -> a));
            for (Place place : plan.plan().places()) {
                BitSet all = new BitSet();
                all.set(0, variables.size());
                at.put(place.id(), place.start() ? entering(place) : all);
            }
            Deque<Transition> open = new ArrayDeque<>(plan.plan().transitions());
            while (!open.isEmpty()) {
                pass(open.pop(), open);
            }
        }

        /** Removes the variables that are not written on the way through a transition, and looks again at those behind it. */
        private void pass(Transition t, Deque<Transition> open) {
            BitSet after = before(t);
            t.inputs().forEach(input -> input.writes().values().forEach(v -> set(after, v)));
            for (Place place : plan.outPlaces(t)) {
                if (!place.start()) {
                    BitSet there = entering(place);
                    there.or(after);
                    BitSet known = written(place);
                    int size = known.cardinality();
                    known.and(there);
                    if (known.cardinality() != size) {
                        open.addAll(plan.outTransitions(place));
                    }
                }
            }
        }

        private BitSet before(Transition t) {
            BitSet needed = new BitSet();
            BitSet common = new BitSet();
            common.set(0, variables.size());
            boolean needs = false;
            for (InEdge edge : plan.inEdges(t)) {
                if (at.containsKey(edge.place())) {
                    BitSet left = new BitSet();
                    left.or(at.get(edge.place()));
                    left.or(askedAt.get(edge.place()));
                    if (needsTokens(edge)) {
                        needed.or(left);
                        needs = true;
                    } else if (edge.requirements().stream().allMatch(r -> r.kind() == TokenKind.UNCONDITIONAL)) {
                        common.and(left);
                    }
                }
            }
            return needs ? needed : common;
        }

        private static boolean needsTokens(InEdge edge) {
            return edge.requirements().stream()
                    .anyMatch(r -> r.kind() == TokenKind.RELEVANT
                            || ((r.match() == Match.AT_LEAST || r.match() == Match.EXACTLY) && r.n() > 0));
        }

        /** What output events write as the place is entered. */
        private BitSet entering(Place place) {
            BitSet written = new BitSet();
            place.outputs().forEach(output -> output.writes().values().forEach(v -> set(written, v)));
            return written;
        }

        /** What is asked of the operator, or written by sub-missions, while tokens stand in a place. */
        private BitSet whileStanding(Place place) {
            BitSet written = new BitSet();
            Set<String> events =
                    place.outputs().stream().map(OutputEventSpec::id).collect(Collectors.toSet());
            plan.scope().redefinitions().stream()
                    .filter(use -> events.contains(use.event()))
                    .forEach(use -> set(written, use.variable()));
            if (!place.subMissions().isEmpty()) {
                for (int i = 0; i < variables.size(); i++) {
                    if (VariableScope.usedByChildren(plan, variables.get(i))) {
                        written.set(i);
                    }
                }
            }
            return written;
        }

        private void set(BitSet set, String variable) {
            int index = variables.indexOf(variable);
            if (index >= 0) {
                set.set(index);
            }
        }

        /** Whether tokens may come to a place before a variable has been written. */
        boolean lacks(Place place, int variable) {
            return !written(place).get(variable);
        }

        private BitSet written(Place place) {
            return Objects.requireNonNull(at.get(place.id()), place.id());
        }
    }
}
