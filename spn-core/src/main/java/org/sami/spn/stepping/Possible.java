package org.sami.spn.stepping;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.Set;
import org.sami.spn.engine.EngineView;
import org.sami.spn.engine.InterruptButton;
import org.sami.spn.engine.MissionView;
import org.sami.spn.model.InputEventSpec;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Transition;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Decision;
import org.sami.spn.vocabulary.EventRole;
import org.sami.spn.vocabulary.EventType;
import org.sami.spn.vocabulary.Vocabulary;

/**
 * What can happen to a plan now; immutable.
 *
 * @param activations what the plan has asked for and still waits for, in order of activation
 * @param decisions what the operator can answer, in order; also what no activation asks, such as the values asked at the start
 * @param interrupts buttons that can be pressed
 * @param news types of input events that some transition waits for now and that nothing needs to have asked for, in the order of
 *     missions and transitions
 * @param nextDueMillis when the next timer or deadline runs down, in milliseconds since the start; empty where none runs
 */
public record Possible(
        List<OpenActivation> activations,
        List<Decision> decisions,
        List<InterruptButton> interrupts,
        List<EventType> news,
        OptionalLong nextDueMillis) {
    public Possible {
        activations = List.copyOf(activations);
        decisions = List.copyOf(decisions);
        interrupts = List.copyOf(interrupts);
        news = List.copyOf(news);
        Objects.requireNonNull(nextDueMillis, "nextDueMillis");
    }

    /**
     * What a plan has asked for.
     *
     * @param answers input events that a domain can answer it with; empty where the operator or the engine answers
     * @param decision the operator's question, where it asks one that is still open
     */
    public record OpenActivation(Activation activation, List<EventType> answers, Optional<Decision> decision) {
        public OpenActivation {
            Objects.requireNonNull(activation, "activation");
            answers = List.copyOf(answers);
            Objects.requireNonNull(decision, "decision");
        }
    }

    static Possible of(EngineView view, Vocabulary vocabulary) {
        List<OpenActivation> activations = new ArrayList<>();
        Set<String> answers = new LinkedHashSet<>();
        for (Activation a : view.openActivations()) {
            OpenActivation open = open(a, view, vocabulary);
            activations.add(open);
            vocabulary.event(a.type()).ifPresent(type -> answers.addAll(type.answers()));
        }
        return new Possible(
                activations,
                view.decisions(),
                view.interrupts(),
                news(view, vocabulary, answers),
                view.nextDueMillis());
    }

    private static OpenActivation open(Activation a, EngineView view, Vocabulary vocabulary) {
        EventType type = vocabulary.event(a.type()).orElseThrow();
        boolean byDomain = type.role() == EventRole.NONE && type.decision().isEmpty();
        return new OpenActivation(
                a,
                byDomain
                        ? type.answers().stream()
                                .flatMap(name -> vocabulary.event(name).stream())
                                .toList()
                        : List.of(),
                view.decisions().stream().filter(d -> d.activation() == a.id()).findFirst());
    }

    private static List<EventType> news(EngineView view, Vocabulary vocabulary, Set<String> answers) {
        Set<EventType> news = new LinkedHashSet<>();
        for (MissionView mission : view.missions()) {
            for (Transition t : view.plan(mission.plan()).map(Plan::transitions).orElse(List.of())) {
                for (InputEventSpec input : t.inputs()) {
                    vocabulary
                            .event(input.type())
                            .filter(type -> type.role() == EventRole.NONE
                                    && !answers.contains(type.name())
                                    && view.awaits(input.type()))
                            .ifPresent(news::add);
                }
            }
        }
        return List.copyOf(news);
    }
}
