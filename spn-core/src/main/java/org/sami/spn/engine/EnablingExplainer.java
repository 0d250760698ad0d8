package org.sami.spn.engine;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.sami.spn.engine.net.CompiledInput;
import org.sami.spn.engine.net.CompiledPlace;
import org.sami.spn.engine.net.CompiledTransition;
import org.sami.spn.engine.net.Reach;
import org.sami.spn.engine.rule.Combinations;
import org.sami.spn.engine.rule.FiringScope;
import org.sami.spn.engine.rule.RelevantTokens;
import org.sami.spn.engine.rule.Rules;
import org.sami.spn.engine.rule.TokenWords;
import org.sami.spn.engine.state.MissionState;
import org.sami.spn.engine.state.NamedToken;
import org.sami.spn.engine.state.NetState;
import org.sami.spn.engine.state.PendingOccurrence;
import org.sami.spn.engine.state.PlaceState;
import org.sami.spn.engine.state.PlacedToken;
import org.sami.spn.engine.state.TransitionState;
import org.sami.spn.model.InRequirement;
import org.sami.spn.model.TokenKind;
import org.sami.spn.protocol.MissionStatus;
import org.sami.spn.protocol.Token;

/** Says in words why a transition cannot fire now. */
final class EnablingExplainer {
    private final NetState state;
    private final Rules rules;
    private final Awaiting awaiting;
    private final ElementWords words;

    EnablingExplainer(NetState state) {
        this.state = state;
        this.rules = new Rules(state);
        this.awaiting = new Awaiting(state);
        this.words = new ElementWords(state);
    }

    EnablingExplanation explain(long mission, String transition) {
        MissionState m = state.missions.get(mission);
        if (m == null) {
            return no("Mission " + mission + " is not running.");
        }
        CompiledTransition t = m.plan.transition(transition);
        if (t == null) {
            return no("The plan '" + m.plan.plan.name() + "' has no transition '" + transition + "'.");
        }
        if (m.status == MissionStatus.WAITING) {
            return no("The mission waits for its parameters.");
        }
        if (m.status == MissionStatus.HALTED) {
            return no("The mission was halted as a livelock; it can only be aborted.");
        }
        return explain(m.transition(t.index));
    }

    private EnablingExplanation explain(TransitionState t) {
        List<String> reasons = new ArrayList<>();
        for (CompiledInput input : t.transition.inputs) {
            if (t.queues[input.index].size == 0) {
                reasons.add("It waits for " + words.event(input)
                        + awaiting.over(t, input)
                                .map(why -> ", which can come no longer: " + why + ".")
                                .orElse(", which has not been received."));
            }
        }
        List<PendingOccurrence> received = new ArrayList<>();
        for (TransitionState.Queue q : t.queues) {
            if (q.first != null) {
                received.add(q.first);
            }
        }
        FiringScope scope = FiringScope.of(t.transition.reach(), received);
        List<String> subMissions = new ArrayList<>();
        for (CompiledPlace place : t.transition.inPlaces) {
            if (scope.reach != Reach.ALL && !rules.enabling.isReady(t, place, scope)) {
                Optional<String> over = Awaiting.endOf(t.mission.places[place.index]);
                String how = over.orElse("which is not complete");
                reasons.add("It waits for the sub-mission on " + words.place(t.mission, place) + ", " + how + ".");
                if (over.isEmpty()) {
                    subMissions.add(place.id());
                }
            }
        }
        if (scope.reach == Reach.FREE && t.transition.wantsSubTokens && !rules.enabling.somethingReturned(t, scope)) {
            reasons.add("It waits for what a sub-mission brings back.");
        }
        RelevantTokens relevant = RelevantTokens.of(received);
        for (CompiledTransition.In in : t.transition.ins) {
            for (InRequirement r : in.requirements()) {
                if (r.kind() == TokenKind.RELEVANT && received.isEmpty()) {
                    continue;
                }
                if (!rules.enabling.isMet(t, in.place(), r, relevant, scope)) {
                    reasons.add(unmet(t, in.place(), r, relevant, scope));
                }
            }
        }
        if (t.barrier != null) {
            addMissing(t, reasons);
        }
        if (reasons.isEmpty() && t.transition.inputs.length > 1) {
            if (new Combinations(rules.enabling).find(t) == null) {
                reasons.add("The events that it has received do not name the same robots or tasks.");
            }
        }
        return new EnablingExplanation(reasons.isEmpty(), reasons, awaiting.awaited(t), subMissions);
    }

    private String unmet(
            TransitionState t, CompiledPlace place, InRequirement r, RelevantTokens relevant, FiringScope scope) {
        PlaceState here = t.mission.places[place.index];
        String what = kind(r);
        String where = atTheBeginning(words.place(t.mission, place));
        int n = here == null ? 0 : rules.enabling.count(here, r, relevant, scope);
        String are = "; there " + (n == 1 ? "is 1." : "are " + n + ".");
        return switch (r.match()) {
            case ZERO -> where + " must have no " + what + are;
            case LESS_THAN -> where + " must have fewer than " + r.n() + " " + what + are;
            case AT_LEAST -> where + " must have at least " + r.n() + " " + what + are;
            case EXACTLY -> where + " must have exactly " + r.n() + " " + what + are;
            case ALL -> where + " lacks " + missing(here, relevant, scope) + ".";
        };
    }

    private static String atTheBeginning(String words) {
        return Character.toUpperCase(words.charAt(0)) + words.substring(1);
    }

    private String missing(PlaceState here, RelevantTokens relevant, FiringScope scope) {
        List<Token> missing = new ArrayList<>();
        for (NamedToken n : relevant.names) {
            boolean found = false;
            for (Token token : n.tokens) {
                found |= here != null && rules.pool.copies(here, token, scope) > 0;
            }
            if (!found) {
                missing.add(n.token);
            }
        }
        return TokenWords.of(missing);
    }

    private void addMissing(TransitionState t, List<String> reasons) {
        List<Token> silent = new ArrayList<>();
        for (CompiledPlace place : t.transition.watched) {
            PlaceState here = t.mission.places[place.index];
            if (here == null) {
                continue;
            }
            for (PlacedToken e : here.inOrder()) {
                if (e.kind() != PlacedToken.GENERIC && !silent.contains(e.token) && !hasReported(t, e.token)) {
                    silent.add(e.token);
                }
            }
        }
        if (!silent.isEmpty()) {
            reasons.add("It waits for all; not yet reported: " + TokenWords.of(silent) + ".");
        } else if (t.allReports().isEmpty()) {
            reasons.add("It waits for all, and nobody is there.");
        }
    }

    private static boolean hasReported(TransitionState t, Token token) {
        for (CompiledInput input : t.transition.inputs) {
            if (!t.allReports().hasReported(input.index, token)) {
                return false;
            }
        }
        return true;
    }

    private static String kind(InRequirement r) {
        return switch (r.kind()) {
            case GENERIC -> "generic tokens";
            case ANY_PROXY -> "robots";
            case ANY_TASK -> "tasks";
            case TASK -> "tokens of task '" + r.task() + "'";
            case RELEVANT -> "relevant tokens";
            default -> "tokens";
        };
    }

    private static EnablingExplanation no(String reason) {
        return new EnablingExplanation(false, List.of(reason));
    }
}
