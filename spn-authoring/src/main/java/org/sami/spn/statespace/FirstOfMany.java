package org.sami.spn.statespace;

import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.sami.spn.engine.MissionView;
import org.sami.spn.model.InEdge;
import org.sami.spn.model.Match;
import org.sami.spn.model.OutRequirement;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;
import org.sami.spn.model.TokenKind;
import org.sami.spn.model.Transition;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Token;
import org.sami.spn.stepping.NextStep;
import org.sami.spn.stepping.Stepper;

/**
 * Places that are drawn for waiting and in which nobody waits: nothing is asked there, and a transition without input events takes the first
 * who comes while others are still on their way to the place.
 */
final class FirstOfMany implements StepObserver {
    /** A place for waiting and the transition that is to let all go on together. */
    record Gate(String place, String transition, boolean alone) {}

    /** The first run in which somebody went on while others were on their way. */
    record Seen(Node from, NextStep last, List<Token> went, Token other, String otherPlace) {}

    private final Plan plan;
    private final PlanRoles roles;
    private final Map<String, Gate> gates = new LinkedHashMap<>();
    private final Map<Gate, Seen> seen = new LinkedHashMap<>();
    private final Set<String> waited = new HashSet<>();

    FirstOfMany(Plan plan, PlanRoles roles) {
        this.plan = plan;
        this.roles = roles;
        plan.transitions().forEach(t -> gate(t).ifPresent(gate -> gates.put(t.id(), gate)));
    }

    private Optional<Gate> gate(Transition t) {
        List<InEdge> edges = plan.inEdgesOf(t.id());
        List<InEdge> wanting = edges.stream().filter(edge -> !onlyForbids(edge)).toList();
        if (!t.inputs().isEmpty() || wanting.size() != 1 || !wantsOne(wanting.get(0)) || !takesAll(t)) {
            return Optional.empty();
        }
        return plan.place(wanting.get(0).place())
                .filter(place -> !place.start()
                        && !place.end()
                        && place.outputs().isEmpty()
                        && place.subMissions().isEmpty())
                .map(place -> new Gate(place.id(), t.id(), edges.size() == 1));
    }

    private static boolean onlyForbids(InEdge edge) {
        return edge.requirements().stream().allMatch(r -> r.match() == Match.ZERO);
    }

    private static boolean wantsOne(InEdge edge) {
        return edge.requirements().stream()
                .anyMatch(r -> r.match() == Match.AT_LEAST && r.n() == 1 && r.kind() != TokenKind.GENERIC);
    }

    private boolean takesAll(Transition t) {
        return plan.outEdgesOf(t.id()).stream()
                .flatMap(edge -> edge.requirements().stream())
                .filter(r -> r.kind() != TokenKind.GENERIC)
                .allMatch(r -> r.n() == OutRequirement.ALL);
    }

    @Override
    public void took(Node from, NextStep step, Stepper before, Stepper after, List<Effect> effects) {
        if (gates.isEmpty()) {
            return;
        }
        after.view()
                .mission(after.mission())
                .filter(mission -> after.outcome().isEmpty())
                .ifPresent(mission -> waited.addAll(mission.marking().keySet()));
        for (Effect effect : effects) {
            if (effect instanceof Effect.Fired fired && fired.mission() == before.mission()) {
                Gate gate = gates.get(fired.transition());
                if (gate != null && !seen.containsKey(gate)) {
                    went(gate, fired, from, step, before);
                }
            }
        }
    }

    private void went(Gate gate, Effect.Fired fired, Node from, NextStep step, Stepper before) {
        List<Token> went = fired.moves().stream()
                .filter(move -> move.from().filter(gate.place()::equals).isPresent())
                .map(move -> move.token())
                .filter(token -> !Token.GENERIC.equals(token))
                .distinct()
                .toList();
        Map<String, List<Token>> marking = before.view()
                .mission(before.mission())
                .map(MissionView::marking)
                .orElse(Map.of());
        for (String onTheWay : placesBefore(gate.place())) {
            for (Token other : marking.getOrDefault(onTheWay, List.of())) {
                boolean alike = went.stream().anyMatch(token -> token.getClass() == other.getClass());
                if (alike && !went.contains(other)) {
                    seen.putIfAbsent(gate, new Seen(from, step, went, other, onTheWay));
                }
            }
        }
    }

    private List<String> placesBefore(String place) {
        return plan.outEdges().stream()
                .filter(edge -> edge.place().equals(place)
                        && plan.transition(edge.transition())
                                .filter(roles::isByButton)
                                .isEmpty())
                .flatMap(edge -> plan.inEdgesOf(edge.transition()).stream())
                .map(InEdge::place)
                .filter(id -> plan.place(id).filter(Place::start).isEmpty())
                .distinct()
                .toList();
    }

    /**
     * Gates at which nobody waited.
     *
     * @param complete whether all states were looked at; else those only that cannot hold anybody
     */
    Map<Gate, Seen> all(boolean complete) {
        Map<Gate, Seen> all = new LinkedHashMap<>(seen);
        all.keySet().removeIf(gate -> waited.contains(gate.place()) || (!complete && !gate.alone()));
        return all;
    }
}
