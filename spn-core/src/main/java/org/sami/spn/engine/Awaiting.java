package org.sami.spn.engine;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.sami.spn.engine.net.CompiledInput;
import org.sami.spn.engine.net.CompiledPlace;
import org.sami.spn.engine.state.Instance;
import org.sami.spn.engine.state.NetState;
import org.sami.spn.engine.state.PlaceState;
import org.sami.spn.engine.state.PlacedToken;
import org.sami.spn.engine.state.SentActivation;
import org.sami.spn.engine.state.SharedRun;
import org.sami.spn.engine.state.TransitionState;
import org.sami.spn.engine.state.Visit;
import org.sami.spn.model.InputEventSpec;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Token;
import org.sami.spn.vocabulary.EventRole;
import org.sami.spn.vocabulary.EventType;
import org.sami.spn.vocabulary.TokenNeed;

/**
 * Which of the input events that a transition has not received can still come. An answer can come no longer when everybody who was
 * asked for it, on the transition's in places, has answered; news can come at any time. What a handler has answered the engine does
 * not know: such an answer counts as one that can come.
 */
final class Awaiting {
    private final NetState state;
    private final ElementWords words;

    Awaiting(NetState state) {
        this.state = state;
        this.words = new ElementWords(state);
    }

    /** The input events that are missing, in the transition's order; none where one of them can come no longer. */
    List<InputEventSpec> awaited(TransitionState t) {
        List<InputEventSpec> awaited = new ArrayList<>();
        for (CompiledInput input : t.transition.inputs) {
            if (t.queues[input.index].size == 0) {
                if (over(t, input).isPresent()) {
                    return List.of();
                }
                awaited.add(input.spec);
            }
        }
        return awaited;
    }

    /** Why an input event that has not been received can come no longer; empty where it can. */
    Optional<String> over(TransitionState t, CompiledInput input) {
        if (input.role == EventRole.CHECK_RETURN || input.role == EventRole.SUB_MISSION_ABORTED) {
            return instancesOver(t);
        }
        Optional<String> over = Optional.empty();
        for (Visit v = t.mission.firstVisit(); v != null; v = v.next) {
            if (!List.of(t.transition.inPlaces).contains(v.place.place)) {
                continue;
            }
            for (SentActivation sent = v.firstSent(); sent != null; sent = sent.next()) {
                if (answers(sent, input)) {
                    Optional<String> answered = answered(sent, t);
                    if (answered.isEmpty()) {
                        return Optional.empty();
                    }
                    over = answered;
                }
            }
        }
        return over;
    }

    private boolean answers(SentActivation sent, CompiledInput input) {
        return sent.output.type.map(EventType::answers).orElse(List.of()).stream()
                .anyMatch(answer -> state.newest().knownTypeId(answer) == input.typeId);
    }

    private Optional<String> answered(SentActivation sent, TransitionState t) {
        String place = words.place(t.mission, sent.visit.place.place);
        if (hasNobodyLeft(sent, t)) {
            return Optional.of("those that " + place + " asked are there no longer");
        }
        if (sent.output.decision != null && sent.decision == Ids.NONE) {
            return Optional.of("what " + place + " asked has been answered");
        }
        boolean isTimer = sent.output.role == EventRole.TIMER || sent.output.role == EventRole.PROXY_TIMER;
        return isTimer && sent.timers.isEmpty()
                ? Optional.of("the timer of " + place + " has expired")
                : Optional.empty();
    }

    /** Whether it asked robots or tasks of which none stands where its answer is for the transition (R-OCC-4). */
    private static boolean hasNobodyLeft(SentActivation sent, TransitionState t) {
        boolean asksTokens = sent.output.type.map(EventType::tokens).orElse(TokenNeed.NONE) != TokenNeed.NONE;
        List<Token> asked = sent.activation.tokens().stream()
                .filter(token -> PlacedToken.kindOf(token) != PlacedToken.GENERIC)
                .toList();
        return asksTokens
                && !asked.isEmpty()
                && asked.stream().noneMatch(token -> sent.visit.has(token) || standsInAnother(token, sent, t));
    }

    private static boolean standsInAnother(Token token, SentActivation sent, TransitionState t) {
        for (CompiledPlace place : t.transition.inPlaces) {
            PlaceState here = t.mission.places[place.index];
            if (here != null && here != sent.visit.place && here.has(token)) {
                return true;
            }
        }
        return false;
    }

    private Optional<String> instancesOver(TransitionState t) {
        Optional<String> over = Optional.empty();
        for (CompiledPlace place : t.transition.inPlaces) {
            PlaceState here = t.mission.places[place.index];
            if (here == null) {
                continue;
            }
            List<Instance> instances = instances(here);
            if (instances.stream().anyMatch(instance -> instance.child != null)) {
                return Optional.empty();
            }
            if (!instances.isEmpty()) {
                over = Optional.of("the sub-mission on " + words.place(t.mission, place) + " is over");
            }
        }
        return over;
    }

    /** Whether a place has instances that were aborted, and none that runs. */
    static boolean wasAborted(PlaceState here) {
        List<Instance> instances = here == null ? List.of() : instances(here);
        return instances.stream().anyMatch(instance -> instance.status == Instance.Status.ABORTED)
                && instances.stream().allMatch(instance -> instance.child == null);
    }

    /** How the sub-mission on a place ended for which a transition waits in vain; empty where it can still complete or return. */
    static Optional<String> endOf(PlaceState here) {
        if (wasAborted(here)) {
            return Optional.of("which was aborted");
        }
        for (SharedRun run : here == null ? new SharedRun[0] : here.shared) {
            if (run.instance.child == null && run.returns.isEmpty()) {
                return Optional.of("whose shared instance is over: nothing comes back from it any longer");
            }
        }
        return Optional.empty();
    }

    private static List<Instance> instances(PlaceState here) {
        List<Instance> instances = new ArrayList<>();
        here.instanceVisits().values().forEach(visit -> instances.addAll(visit.instances));
        for (SharedRun run : here.shared) {
            instances.add(run.instance);
        }
        return instances;
    }
}
