package org.sami.spn.wizard;

import java.util.EnumSet;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.sami.spn.model.Action;
import org.sami.spn.model.InEdge;
import org.sami.spn.model.InputEventSpec;
import org.sami.spn.model.Match;
import org.sami.spn.model.OutEdge;
import org.sami.spn.model.OutRequirement;
import org.sami.spn.model.OutputEventSpec;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;
import org.sami.spn.model.TokenKind;
import org.sami.spn.model.Transition;
import org.sami.spn.model.WaitFor;
import org.sami.spn.sequence.AuthoringLibrary;
import org.sami.spn.sequence.Sequence;
import org.sami.spn.vocabulary.TokenNeed;

/**
 * Which tokens must come into each place so that its output events, and those of places behind it, get what they need; and which places the
 * generic token can reach. Both follow from the sequences of the events and from what locked edges ask, not from other requirements: it is
 * those that are computed.
 */
final class CarriedTokens {
    /** The two kinds of tokens that events need. */
    enum Need {
        PROXY,
        TASK
    }

    private final Plan plan;
    private final AuthoringLibrary library;
    private final Map<String, Set<Need>> needs = new HashMap<>();
    private final Map<String, Boolean> generic = new HashMap<>();

    CarriedTokens(Plan plan, AuthoringLibrary library) {
        this.plan = plan;
        this.library = library;
        for (Place place : plan.places()) {
            Set<Need> own = EnumSet.noneOf(Need.class);
            place.outputs().stream().map(OutputEventSpec::type).forEach(e -> add(own, library.needs(e)));
            needs.put(place.id(), own);
            generic.put(place.id(), place.start());
        }
        boolean more = true;
        while (more) {
            more = false;
            for (OutEdge edge : plan.outEdges()) {
                more |= needsBefore(edge);
                more |= genericBehind(edge);
            }
        }
    }

    private static void add(Set<Need> needs, TokenNeed need) {
        if (need == TokenNeed.TASK) {
            needs.add(Need.TASK);
        } else if (need != TokenNeed.NONE) {
            needs.add(Need.PROXY);
        }
    }

    /** The needs of what stands in and behind a place. */
    Set<Need> of(String place) {
        return needs.getOrDefault(place, Set.of());
    }

    /** Whether the generic token comes to a place. */
    boolean hasGeneric(String place) {
        return generic.getOrDefault(place, false);
    }

    /** Whether the generic token goes through a transition, or begins in it. */
    boolean movesGeneric(Transition transition) {
        List<InEdge> before = plan.inEdgesOf(transition.id());
        boolean arrives = before.isEmpty() || before.stream().anyMatch(e -> hasGeneric(e.place()));
        return arrives
                && transition.inputs().stream()
                        .allMatch(i -> library.ofInput(i.type())
                                .map(s -> s.movesGeneric() && !firesForEach(transition, s))
                                .orElse(true));
    }

    /** Whether what usually waits for all fires for each answer here: the first would take the generic token from the others. */
    private static boolean firesForEach(Transition transition, Sequence.OfInput sequence) {
        return sequence.waitFor() == WaitFor.ALL && transition.waitFor() == WaitFor.EACH;
    }

    private boolean needsBefore(OutEdge edge) {
        boolean more = false;
        for (Need need : of(edge.place())) {
            boolean taken = edge.locked() ? takes(edge.requirements(), need) : !addedBy(edge.transition(), need);
            if (taken) {
                for (String place : placesBefore(edge.transition())) {
                    more |= needs.computeIfAbsent(place, one -> EnumSet.noneOf(Need.class))
                            .add(need);
                }
            }
        }
        return more;
    }

    private List<String> placesBefore(String transition) {
        return plan.inEdgesOf(transition).stream()
                .filter(e -> e.requirements().stream().noneMatch(r -> r.match() == Match.ZERO))
                .map(InEdge::place)
                .filter(needs::containsKey)
                .toList();
    }

    private boolean genericBehind(OutEdge edge) {
        if (hasGeneric(edge.place())) {
            return false;
        }
        boolean moved = edge.locked()
                ? edge.requirements().stream().anyMatch(CarriedTokens::takesGeneric)
                : plan.transition(edge.transition()).filter(this::movesGeneric).isPresent();
        if (moved) {
            generic.put(edge.place(), true);
        }
        return moved;
    }

    /** Whether an answer that names tokens from elsewhere brings them into the plan, such as a robot that was made. */
    private boolean addedBy(String transition, Need need) {
        return plan.transition(transition).stream()
                .flatMap(t -> t.inputs().stream())
                .map(InputEventSpec::type)
                .flatMap(e -> library.ofInput(e).stream())
                .flatMap(s -> s.out().stream())
                .anyMatch(r -> r.action() == Action.ADD && brings(r, need));
    }

    /** Whether a requirement of an out edge brings tokens of a kind into its place. */
    static boolean brings(OutRequirement requirement, Need need) {
        if (requirement.action() == Action.CONSUME) {
            return false;
        }
        return switch (requirement.kind()) {
            case ANY_TOKEN, RELEVANT, SUB_MISSION_TOKENS -> true;
            case ANY_PROXY -> need == Need.PROXY;
            case ANY_TASK, TASK -> need == Need.TASK;
            case GENERIC, UNCONDITIONAL -> false;
        };
    }

    static boolean takes(List<OutRequirement> requirements, Need need) {
        return requirements.stream().anyMatch(r -> brings(r, need));
    }

    private static boolean takesGeneric(OutRequirement requirement) {
        return requirement.action() != Action.CONSUME
                && (requirement.kind() == TokenKind.GENERIC || requirement.kind() == TokenKind.ANY_TOKEN);
    }
}
