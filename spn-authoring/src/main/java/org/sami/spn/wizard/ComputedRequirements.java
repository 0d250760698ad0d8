package org.sami.spn.wizard;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.sami.spn.model.Action;
import org.sami.spn.model.InEdge;
import org.sami.spn.model.InRequirement;
import org.sami.spn.model.InputEventSpec;
import org.sami.spn.model.Match;
import org.sami.spn.model.OutEdge;
import org.sami.spn.model.OutRequirement;
import org.sami.spn.model.Plan;
import org.sami.spn.model.TokenKind;
import org.sami.spn.model.Transition;
import org.sami.spn.sequence.AuthoringLibrary;
import org.sami.spn.sequence.Sequence;
import org.sami.spn.vocabulary.EventType;
import org.sami.spn.vocabulary.Vocabulary;
import org.sami.spn.wizard.CarriedTokens.Need;

/**
 * The requirements that the edges of a plan need for its events to work (thesis 5.1.1, Edge Requirement Computation): those of the flexible
 * sequences of a transition's input events, the generic token that goes on through the plan, and the tokens that the output events behind an
 * edge need. Locked edges are not in it.
 */
final class ComputedRequirements {
    private static final InRequirement ONE_GENERIC = InRequirement.of(TokenKind.GENERIC, Match.AT_LEAST, 1);

    private final Plan plan;
    private final Vocabulary vocabulary;
    private final AuthoringLibrary library;
    private final CarriedTokens carried;
    private final Map<String, List<InRequirement>> in = new LinkedHashMap<>();
    private final Map<String, List<OutRequirement>> out = new LinkedHashMap<>();

    ComputedRequirements(Plan plan, Vocabulary vocabulary, AuthoringLibrary library) {
        this.plan = plan;
        this.vocabulary = vocabulary;
        this.library = library;
        this.carried = new CarriedTokens(plan, library);
        plan.transitions().forEach(this::compute);
    }

    /** What an in edge needs; empty for one that is locked. */
    List<InRequirement> in(String edge) {
        return in.getOrDefault(edge, List.of());
    }

    /** What an out edge needs; empty for one that is locked. */
    List<OutRequirement> out(String edge) {
        return out.getOrDefault(edge, List.of());
    }

    private void compute(Transition transition) {
        List<Sequence.OfInput> sequences = transition.inputs().stream()
                .flatMap(i -> library.ofInput(i.type()).stream())
                .toList();
        List<InEdge> before = plan.inEdgesOf(transition.id());
        boolean generic = carried.movesGeneric(transition);
        List<InEdge> asking =
                before.stream().filter(e -> asks(e.place(), transition)).toList();
        for (InEdge edge : before) {
            if (!edge.locked()) {
                Set<InRequirement> needed = new LinkedHashSet<>();
                if (asking.isEmpty() || asking.contains(edge)) {
                    sequences.forEach(s -> needed.addAll(s.in()));
                }
                if (generic && carried.hasGeneric(edge.place())) {
                    needed.add(ONE_GENERIC);
                }
                in.put(edge.id(), needed.isEmpty() ? otherwise(edge, transition) : List.copyOf(needed));
            }
        }
        for (OutEdge edge : plan.outEdgesOf(transition.id())) {
            if (!edge.locked()) {
                out.put(edge.id(), out(edge, transition, sequences, generic));
            }
        }
    }

    /** Whether a place asks for what one of the transition's input events answers. */
    private boolean asks(String place, Transition transition) {
        Set<String> awaited = new LinkedHashSet<>();
        transition.inputs().stream().map(InputEventSpec::type).forEach(awaited::add);
        return plan.place(place).stream()
                .flatMap(p -> p.outputs().stream())
                .flatMap(o -> vocabulary.event(o.type()).stream())
                .map(EventType::answers)
                .anyMatch(answers -> answers.stream().anyMatch(awaited::contains));
    }

    /** Where no event asks for tokens and no generic token comes, what the places behind need is waited for. */
    private List<InRequirement> otherwise(InEdge edge, Transition transition) {
        Set<InRequirement> needed = new LinkedHashSet<>();
        for (OutEdge next : plan.outEdgesOf(transition.id())) {
            for (Need need : carried.of(next.place())) {
                if (carried.of(edge.place()).contains(need)) {
                    needed.add(InRequirement.of(kind(need), Match.AT_LEAST, 1));
                }
            }
        }
        return needed.isEmpty() ? List.of(InRequirement.unconditional()) : List.copyOf(needed);
    }

    private List<OutRequirement> out(
            OutEdge edge, Transition transition, List<Sequence.OfInput> sequences, boolean generic) {
        Set<OutRequirement> needed = new LinkedHashSet<>();
        sequences.forEach(s -> needed.addAll(s.out()));
        if (generic) {
            boolean begins = plan.inEdgesOf(transition.id()).isEmpty();
            needed.add(OutRequirement.of(begins ? Action.ADD : Action.TAKE, 1, TokenKind.GENERIC));
        }
        for (Need need : carried.of(edge.place())) {
            if (!CarriedTokens.takes(new ArrayList<>(needed), need)) {
                needed.add(OutRequirement.of(Action.TAKE, OutRequirement.ALL, kind(need)));
            }
        }
        return needed.isEmpty() ? List.of(OutRequirement.unconditional()) : List.copyOf(needed);
    }

    private static TokenKind kind(Need need) {
        return need == Need.PROXY ? TokenKind.ANY_PROXY : TokenKind.ANY_TASK;
    }
}
