package org.sami.crw.operator.mission;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.sami.crw.fleet.FleetWants;
import org.sami.crw.handler.activation.EventNames;
import org.sami.spn.engine.EnablingExplanation;
import org.sami.spn.engine.EngineView;
import org.sami.spn.engine.MissionView;
import org.sami.spn.model.InEdge;
import org.sami.spn.model.InputEventSpec;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Transition;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Decision;
import org.sami.spn.protocol.MissionStatus;
import org.sami.spn.protocol.Token;
import org.sami.spn.value.TextValue;
import org.sami.spn.vocabulary.DecisionType;
import org.sami.spn.vocabulary.EventRole;
import org.sami.spn.vocabulary.EventType;
import org.sami.spn.vocabulary.Reserved;
import org.sami.spn.vocabulary.Vocabulary;

/**
 * How transitions of missions may come to fire: what they wait for is under way, comes by itself, needs a press of the operator, or will not come.
 * The one place with this judgement, for runs that end when nothing can happen and for the missions shown to the operator (docs/session.md). For the
 * thread that owns the state.
 */
public final class Outlooks {
    private final Vocabulary vocabulary;
    private final EngineView view;
    private final FleetWants wants;
    private final FailedAnswers failed;
    private final Set<String> answersOfOperators = new HashSet<>();

    /**
     * A transition and how it may come to fire.
     *
     * @param places ids of its in places
     * @param news the events that come by themselves for which it waits
     * @param presses names of the interrupts for which it waits
     * @param dead the failed activations whose answers it waits for
     */
    record Of(
            Transition transition,
            List<String> places,
            Outlook outlook,
            List<String> news,
            List<String> presses,
            List<Activation> dead) {}

    /** At the present state, with the work under way outside the engine. */
    public Outlooks(Vocabulary vocabulary, EngineView view, FleetWants wants, FailedAnswers failed) {
        this.vocabulary = vocabulary;
        this.view = view;
        this.wants = wants;
        this.failed = failed;
        for (EventType type : vocabulary.events().values()) {
            type.decision().map(DecisionType::accepted).ifPresent(answersOfOperators::add);
            type.decision().map(DecisionType::rejected).ifPresent(answersOfOperators::add);
        }
    }

    /** Whether some mission waits for news that come by themselves: then it can go on though nothing is under way. */
    public boolean isNewsAwaited() {
        return view.missions().stream()
                .anyMatch(mission ->
                        of(mission).stream().anyMatch(one -> !one.news().isEmpty()));
    }

    /** The transitions of a mission that have a marked in place, or need none; without those that wait for its abort or completion only. */
    List<Of> of(MissionView mission) {
        Optional<Plan> plan = view.planOf(mission.id());
        if (plan.isEmpty() || mission.status() != MissionStatus.RUNNING) {
            return List.of();
        }
        List<Of> all = new ArrayList<>();
        for (Transition transition : plan.get().transitions()) {
            List<String> places = plan.get().inEdgesOf(transition.id()).stream()
                    .map(InEdge::place)
                    .toList();
            if ((places.isEmpty() || places.stream().anyMatch(place -> isMarked(mission, place)))
                    && !comesAtAnyTime(transition)) {
                all.add(of(mission, transition, places));
            }
        }
        return all;
    }

    /** Whether somebody stands in a place, or a visit of nobody goes on there. */
    private boolean isMarked(MissionView mission, String place) {
        return mission.marking().containsKey(place)
                || visitors(mission, place).stream().findFirst().isPresent();
    }

    private List<Activation> visitors(MissionView mission, String place) {
        return view.openActivations().stream()
                .filter(one -> one.mission() == mission.id() && one.place().equals(place))
                .toList();
    }

    private Of of(MissionView mission, Transition transition, List<String> places) {
        EnablingExplanation why = view.whyNotEnabled(mission.id(), transition.id());
        Set<Outlook> outlooks = new HashSet<>();
        List<String> news = new ArrayList<>();
        List<String> presses = new ArrayList<>();
        Set<Activation> dead = new LinkedHashSet<>();
        List<Activation> asked = places.stream()
                .flatMap(place -> visitors(mission, place).stream())
                .toList();
        for (InputEventSpec input : why.awaited()) {
            Outlook one = outlook(mission, input, asked, dead);
            outlooks.add(one);
            if (one == Outlook.NEWS) {
                news.add(input.type());
            } else if (one == Outlook.PRESS && input.fields().get(Reserved.INTERRUPT_NAME) instanceof TextValue name) {
                presses.add(name.value());
            }
        }
        if (why.yes() || !why.awaitedSubMissions().isEmpty()) {
            outlooks.add(Outlook.UNDER_WAY);
        }
        return new Of(transition, places, worst(outlooks), news, presses, List.copyOf(dead));
    }

    /** What is missing most counts: a transition waits for all of its events. */
    private static Outlook worst(Set<Outlook> outlooks) {
        return List.of(Outlook.NEVER, Outlook.OTHERS, Outlook.PRESS, Outlook.NEWS, Outlook.UNDER_WAY).stream()
                .filter(outlooks::contains)
                .findFirst()
                .orElse(Outlook.OTHERS);
    }

    private Outlook outlook(MissionView mission, InputEventSpec input, List<Activation> asked, Set<Activation> dead) {
        Optional<EventType> type = vocabulary.event(input.type());
        EventRole role = type.map(EventType::role).orElse(EventRole.NONE);
        if (isPress(role)) {
            return Outlook.PRESS;
        }
        if (role != EventRole.NONE) {
            return Outlook.UNDER_WAY; // the engine says itself what can come no longer
        }
        String name = type.map(EventType::name).orElse(input.type());
        List<Activation> askers = asked.stream()
                .filter(one -> vocabulary.event(one.type()).stream()
                        .anyMatch(asks -> asks.answers().contains(name)))
                .toList();
        if (answersOfOperators.contains(name)) {
            return asksOperator(mission.id()) ? Outlook.UNDER_WAY : Outlook.OTHERS;
        }
        if (wants.computing().contains(mission.id()) || wants.asking().contains(mission.id())) {
            return Outlook.UNDER_WAY;
        }
        boolean isOfCommand = EventNames.OF_COMMANDS.contains(name);
        if (isOfCommand && isCommanded(mission, askers)) {
            return Outlook.UNDER_WAY;
        }
        List<Activation> failing = askers.stream()
                .filter(one -> hasFailed(mission, one, isOfCommand))
                .toList();
        if (!failing.isEmpty() && failing.size() == askers.size()) {
            dead.addAll(failing);
            return Outlook.NEVER;
        }
        return isOfCommand ? Outlook.OTHERS : Outlook.NEWS;
    }

    private boolean asksOperator(long mission) {
        return view.decisions().stream().mapToLong(Decision::mission).anyMatch(asking -> asking == mission);
    }

    /** Whether a boat to which one of the activations speaks has a command of the mission; without such an activation, any boat. */
    private boolean isCommanded(MissionView mission, List<Activation> askers) {
        Set<String> commanded = wants.boatsOf(mission.id());
        return askers.isEmpty()
                ? !commanded.isEmpty()
                : askers.stream()
                        .flatMap(one -> standing(mission, one).stream())
                        .anyMatch(commanded::contains);
    }

    /**
     * Whether an activation will bring no answer any more.
     *
     * @param isOfCommand whether no boat of it has a command any longer: then one failure is enough
     */
    private boolean hasFailed(MissionView mission, Activation activation, boolean isOfCommand) {
        List<FailedAnswers.Failure> failures = failed.of(activation.id());
        Set<String> boats = standing(mission, activation);
        return failures.stream().anyMatch(one -> one.boat().isEmpty())
                || (isOfCommand
                        ? failures.stream().anyMatch(one -> boats.contains(one.boat()))
                        : !boats.isEmpty()
                                && boats.stream()
                                        .allMatch(boat -> failures.stream()
                                                .anyMatch(one -> one.boat().equals(boat))));
    }

    /** The boats to which an activation speaks that still stand in its place. */
    static Set<String> standing(MissionView mission, Activation activation) {
        List<Token> here = mission.marking().getOrDefault(activation.place(), List.of());
        Set<String> boats = new LinkedHashSet<>();
        for (Token token : activation.tokens()) {
            if (!here.contains(token)) {
                continue;
            }
            if (token instanceof Token.Proxy proxy) {
                boats.add(proxy.proxy());
            } else if (token instanceof Token.Task task
                    && activation.allocation().containsKey(task.task())) {
                boats.add(activation.allocation().get(task.task()));
            }
        }
        return boats;
    }

    private static boolean isPress(EventRole role) {
        return role == EventRole.INTERRUPT
                || role == EventRole.GENERAL_INTERRUPT_RECEIVED
                || role == EventRole.PROXY_INTERRUPT_RECEIVED;
    }

    private boolean comesAtAnyTime(Transition transition) {
        return !transition.inputs().isEmpty()
                && transition.inputs().stream()
                        .map(input -> vocabulary.event(input.type()).map(EventType::role))
                        .allMatch(role -> role.filter(
                                        one -> one == EventRole.ABORT_RECEIVED || one == EventRole.COMPLETE_RECEIVED)
                                .isPresent());
    }
}
