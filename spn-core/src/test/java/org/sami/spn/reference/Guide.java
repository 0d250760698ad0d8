package org.sami.spn.reference;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.sami.spn.model.InEdge;
import org.sami.spn.model.InRequirement;
import org.sami.spn.model.InputEventSpec;
import org.sami.spn.model.Match;
import org.sami.spn.model.Plan;
import org.sami.spn.model.TokenKind;
import org.sami.spn.model.Transition;
import org.sami.spn.model.WaitFor;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Answer;
import org.sami.spn.protocol.Answerer;
import org.sami.spn.protocol.Decision;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.Occurrence;
import org.sami.spn.protocol.Token;
import org.sami.spn.testing.TestVocabulary;
import org.sami.spn.value.TaskId;
import org.sami.spn.value.TextValue;
import org.sami.spn.vocabulary.DecisionType;
import org.sami.spn.vocabulary.EventRole;
import org.sami.spn.vocabulary.EventType;

/**
 * Finds inputs that let a transition fire: the events that it waits for, from those who stand in its places. Prefers
 * transitions that have fired seldom.
 */
final class Guide {
    /** A transition of a running mission, with the tokens in the mission's places. */
    private record Candidate(long mission, Plan plan, Transition transition, Map<String, List<Token>> marking) {}

    private final Dice dice;
    private final Seen seen;
    private final Answering answering;

    Guide(Dice dice, Seen seen, Answering answering) {
        this.dice = dice;
        this.seen = seen;
        this.answering = answering;
    }

    /** Inputs for one transition, in order; none where nothing waits for any. */
    List<Input> next(Subject subject) {
        Map<Long, Map<String, List<Token>>> markings = subject.markings();
        Map<Long, String> statuses = subject.statuses();
        List<Activation> open = seen.open(subject);
        List<Candidate> candidates = new ArrayList<>();
        markings.forEach((mission, marking) -> {
            if (statuses.get(mission).equals("RUNNING")) {
                Plan plan = seen.plans.get(mission);
                for (Transition t : plan.transitions()) {
                    Candidate c = new Candidate(mission, plan, t, marking);
                    if (!t.inputs().isEmpty()
                            && isPossible(c, open)
                            && (!endsIt(t) || dice.chance(8))
                            && !isBusy(c, statuses)) {
                        candidates.add(c);
                    }
                }
            }
        });
        if (candidates.isEmpty()) {
            return List.of();
        }
        Candidate best = dice.pick(candidates);
        for (int i = 0; i < 3; i++) {
            Candidate other = dice.pick(candidates);
            if (firings(other) < firings(best)) {
                best = other;
            }
        }
        return inputs(best, subject, open);
    }

    /** Whether the tokens of one of its places are in a sub-mission that runs, as far as can be seen. */
    private boolean isBusy(Candidate c, Map<Long, String> statuses) {
        return c.plan.inEdgesOf(c.transition.id()).stream()
                        .flatMap(e -> c.plan.place(e.place()).orElseThrow().subMissions().stream())
                        .anyMatch(s -> !s.shared()
                                && statuses.keySet().stream()
                                        .anyMatch(m -> seen.parents.get(m) == c.mission
                                                && seen.plans.get(m).id().equals(s.plan())))
                && !takesOut(c.transition)
                && dice.chance(85);
    }

    private static boolean takesOut(Transition t) {
        return t.inputs().stream()
                .map(i -> TestVocabulary.TEST.event(i.type()).orElseThrow().role())
                .anyMatch(role -> World.overrides(role) || role == EventRole.SUB_MISSION_ABORTED);
    }

    private static boolean endsIt(Transition t) {
        return t.inputs().stream()
                .map(i -> TestVocabulary.TEST.event(i.type()).orElseThrow().role())
                .anyMatch(role -> role == EventRole.ABORT_RECEIVED || role == EventRole.COMPLETE_RECEIVED);
    }

    private int firings(Candidate c) {
        return seen.firings(c.plan, c.transition.id());
    }

    /** Whether its places hold what it asks for, as far as that does not depend on whom an event names. */
    private static boolean isPossible(Candidate c, List<Activation> open) {
        boolean somewhere = false;
        for (InEdge edge : c.plan.inEdgesOf(c.transition.id())) {
            List<Token> here = c.marking.getOrDefault(edge.place(), List.of());
            boolean isVisited = !here.isEmpty()
                    || open.stream()
                            .anyMatch(a -> a.mission() == c.mission && a.place().equals(edge.place()));
            somewhere |= isVisited;
            if (!edge.requirements().stream().allMatch(r -> mayHold(r, here))) {
                return false;
            }
        }
        return somewhere || c.plan.inEdgesOf(c.transition.id()).isEmpty();
    }

    private static boolean mayHold(InRequirement r, List<Token> here) {
        long n = here.stream().filter(token -> isOfKind(r, token)).count();
        boolean isNamed = r.kind() == TokenKind.RELEVANT;
        return switch (r.match()) {
            case ZERO -> isNamed || n == 0;
            case LESS_THAN -> isNamed || n < r.n();
            case EXACTLY -> isNamed ? n >= r.n() : n == r.n();
            case AT_LEAST -> n >= r.n();
            case ALL -> r.kind() == TokenKind.UNCONDITIONAL || n > 0;
        };
    }

    private static boolean isOfKind(InRequirement r, Token token) {
        return switch (r.kind()) {
            case GENERIC -> token instanceof Token.Generic;
            case ANY_PROXY -> token instanceof Token.Proxy;
            case ANY_TASK, TASK -> token instanceof Token.Task;
            case ANY_TOKEN -> true;
            case RELEVANT -> !(token instanceof Token.Generic);
            case SUB_MISSION_TOKENS, UNCONDITIONAL -> false;
        };
    }

    // ---- Its events

    private List<Input> inputs(Candidate c, Subject subject, List<Activation> open) {
        List<List<Token>> named = new ArrayList<>();
        List<Token> there = whoIsThere(c);
        if (c.transition.waitFor() == WaitFor.ALL) {
            there.forEach(token -> named.add(List.of(token)));
        } else if (!there.isEmpty()) {
            named.add(wantsAll(c) ? there : dice.some(there));
        }
        if (named.isEmpty()) {
            named.add(List.of());
        }
        List<Input> inputs = new ArrayList<>();
        for (List<Token> names : named) {
            for (InputEventSpec event : c.transition.inputs()) {
                input(c, event, names, subject, open).ifPresent(inputs::add);
            }
        }
        return inputs;
    }

    private static boolean wantsAll(Candidate c) {
        return c.plan.inEdgesOf(c.transition.id()).stream()
                .flatMap(e -> e.requirements().stream())
                .anyMatch(r -> r.kind() == TokenKind.RELEVANT && r.match() != Match.ALL && r.n() > 1);
    }

    /** Boats and tasks in the places whose edges speak of relevant tokens; where none does, in all its places. */
    private List<Token> whoIsThere(Candidate c) {
        List<InEdge> edges = c.plan.inEdgesOf(c.transition.id());
        List<InEdge> speaking = edges.stream()
                .filter(e -> e.requirements().stream()
                        .anyMatch(r -> r.kind() == TokenKind.RELEVANT && r.match() != Match.ZERO))
                .toList();
        List<Token> tokens = (speaking.isEmpty() ? edges : speaking)
                .stream()
                        .flatMap(e -> c.marking.getOrDefault(e.place(), List.of()).stream())
                        .filter(token -> !(token instanceof Token.Generic))
                        .distinct()
                        .toList();
        List<Token> boats =
                tokens.stream().filter(Token.Proxy.class::isInstance).toList();
        List<Token> tasks = tokens.stream().filter(Token.Task.class::isInstance).toList();
        if (c.transition.waitFor() == WaitFor.ALL) {
            return tokens;
        }
        if (edges.isEmpty()) {
            return seen.joined.stream().<Token>map(Token.Proxy::new).toList();
        }
        return boats.isEmpty() || (!tasks.isEmpty() && dice.chance(40)) ? tasks : boats;
    }

    private Optional<Input> input(
            Candidate c, InputEventSpec event, List<Token> named, Subject subject, List<Activation> open) {
        EventType type = TestVocabulary.TEST.event(event.type()).orElseThrow();
        List<String> boats = named.stream()
                .filter(Token.Proxy.class::isInstance)
                .map(t -> ((Token.Proxy) t).proxy())
                .toList();
        List<TaskId> tasks = named.stream()
                .filter(Token.Task.class::isInstance)
                .map(t -> ((Token.Task) t).task())
                .toList();
        return switch (type.role()) {
            case INTERRUPT ->
                Optional.of(new Input.Interrupt(
                        c.mission, ((TextValue) event.fields().get("interruptName")).value(), boats));
            case GENERAL_INTERRUPT_RECEIVED -> Optional.of(new Input.Interrupt(c.mission, "stop", List.of()));
            case PROXY_INTERRUPT_RECEIVED ->
                Optional.of(new Input.Interrupt(c.mission, "stop", dice.chance(25) ? List.of() : boats));
            case ABORT_RECEIVED -> Optional.of(new Input.AbortMission(c.mission));
            case COMPLETE_RECEIVED -> Optional.of(new Input.CompleteMission(c.mission));
            case SUB_MISSION_ABORTED -> child(c, subject).map(Input.AbortMission::new);
            case TIMER_EXPIRED, PROXY_TIMER_EXPIRED -> Optional.of(new Input.TimeReached());
            case TOKENS_RETURNED, CHECK_RETURN -> Optional.empty();
            default -> answer(c, type, boats, tasks, subject, open).or(() -> news(c, type, boats, tasks));
        };
    }

    private Optional<Long> child(Candidate c, Subject subject) {
        List<Long> children = subject.statuses().keySet().stream()
                .filter(m -> seen.parents.get(m) == c.mission)
                .toList();
        return children.isEmpty() ? Optional.empty() : Optional.of(dice.pick(children));
    }

    /** An answer to what a place of the transition asked, by the operator or as it comes from a boat. */
    private Optional<Input> answer(
            Candidate c,
            EventType type,
            List<String> boats,
            List<TaskId> tasks,
            Subject subject,
            List<Activation> open) {
        Set<String> places = Set.copyOf(
                c.plan.inEdgesOf(c.transition.id()).stream().map(InEdge::place).toList());
        List<Activation> asked = open.stream()
                .filter(a -> a.mission() == c.mission && places.contains(a.place()))
                .filter(a -> TestVocabulary.TEST
                        .event(a.type())
                        .orElseThrow()
                        .answers()
                        .contains(type.name()))
                .toList();
        for (Activation a : asked) {
            Optional<Decision> question = seen.openDecisions(subject).stream()
                    .filter(d -> d.activation() == a.id())
                    .findFirst();
            if (question.isPresent()) {
                DecisionType form = TestVocabulary.TEST
                        .event(a.type())
                        .orElseThrow()
                        .decision()
                        .orElseThrow();
                Answer answer = answering.fitting(
                        question.get().question(), form.accepted().equals(type.name()), boats);
                return Optional.of(new Input.AnswerDecision(question.get().id(), answer, Answerer.OPERATOR));
            }
        }
        List<Activation> fitting = asked.stream()
                .filter(a -> boats.isEmpty() || a.proxies().stream().anyMatch(boats::contains))
                .toList();
        if (asked.isEmpty()) {
            return Optional.empty();
        }
        Activation a = dice.pick(fitting.isEmpty() ? asked : fitting);
        return Optional.of(new Input.Received(
                new Occurrence(type.name(), a.mission(), a.id(), boats, tasks, answering.values(type.name()))));
    }

    private Optional<Input> news(Candidate c, EventType type, List<String> boats, List<TaskId> tasks) {
        if (type.role() != EventRole.NONE) {
            return Optional.empty();
        }
        long mission = dice.chance(60) ? c.mission : Ids.NONE;
        return Optional.of(new Input.Received(
                new Occurrence(type.name(), mission, Ids.NONE, boats, tasks, answering.values(type.name()))));
    }
}
