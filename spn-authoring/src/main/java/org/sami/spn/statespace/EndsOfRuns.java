package org.sami.spn.statespace;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.FollowedMarking;
import org.sami.spn.protocol.Outcome;
import org.sami.spn.protocol.Token;
import org.sami.spn.stepping.NextStep;
import org.sami.spn.stepping.Stepper;

/**
 * Which tokens a mission leaves in which places when it ends. The kind of token that reaches the end decides which are counted: where boats do, boats; where
 * tasks do, tasks. Tokens in the start place or not chosen take no part; those that the operator left out, and an end that he makes by a
 * button, is as he wants it.
 */
final class EndsOfRuns implements StepObserver {
    /** Why somebody is left somewhere. */
    enum Why {
        /** What was asked of him there is not answered yet. */
        UNDER_WAY,
        /** The transition that ends the mission looks at the place and takes only some who stand there. */
        NOT_TAKEN,
        /** The transition that ends the mission does not look at the place. */
        FORGOTTEN
    }

    /** The transition that ends the mission, and the tokens that it leaves in each place. */
    record Left(Why why, String transition, String place) {}

    /** The first run in which that was seen. */
    record Seen(Node from, NextStep last, List<Token> atEnd, List<Token> left) {}

    private final Plan plan;
    private final PlanRoles roles;
    private final Map<Left, Seen> all = new LinkedHashMap<>();

    EndsOfRuns(Plan plan, PlanRoles roles) {
        this.plan = plan;
        this.roles = roles;
    }

    @Override
    public void took(Node from, NextStep step, Stepper before, Stepper after, List<Effect> effects) {
        if (after.outcome().filter(Outcome.ENDED::equals).isEmpty()
                || step.kind() == NextStep.Kind.INTERRUPT
                || step.kind() == NextStep.Kind.EMPTY) {
            return;
        }
        long mission = before.mission();
        FollowedMarking marking = new FollowedMarking();
        before.view().markingAsEffects().forEach(marking);
        String ending = "";
        for (Effect effect : effects) {
            if (effect instanceof Effect.MissionEnded ended && ended.mission() == mission) {
                break;
            }
            marking.accept(effect);
            if (effect instanceof Effect.Fired fired && fired.mission() == mission) {
                ending = fired.transition();
            }
        }
        look(from, step, ending, marking.marking(mission));
    }

    private void look(Node from, NextStep step, String ending, Map<String, List<Token>> marking) {
        Set<Token> atEnd = new HashSet<>();
        plan.places().stream()
                .filter(Place::end)
                .forEach(end -> atEnd.addAll(marking.getOrDefault(end.id(), List.of())));
        boolean robots = atEnd.stream().anyMatch(Token.Proxy.class::isInstance);
        boolean tasks = atEnd.stream().anyMatch(Token.Task.class::isInstance);
        for (Place place : plan.places()) {
            List<Token> left = new ArrayList<>();
            for (Token token : marking.getOrDefault(place.id(), List.of())) {
                boolean concerned = token instanceof Token.Proxy ? robots : token instanceof Token.Task && tasks;
                if (concerned && !atEnd.contains(token)) {
                    left.add(token);
                }
            }
            if (!left.isEmpty() && takesPart(place)) {
                all.putIfAbsent(
                        new Left(why(place, ending), ending, place.id()),
                        new Seen(from, step, List.copyOf(atEnd), left));
            }
        }
    }

    private boolean takesPart(Place place) {
        return !place.start() && !place.end() && !roles.isChoice(place) && !roles.isLeftOutByOperator(place);
    }

    private Why why(Place place, String ending) {
        if (roles.isWork(place)) {
            return Why.UNDER_WAY;
        }
        boolean looksAt =
                plan.inEdgesOf(ending).stream().anyMatch(edge -> edge.place().equals(place.id()));
        return looksAt ? Why.NOT_TAKEN : Why.FORGOTTEN;
    }

    Map<Left, Seen> all() {
        return all;
    }
}
