package org.sami.crw.session;

import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.sami.crw.decision.DecisionPresenter;
import org.sami.crw.session.SessionOperator.Asked;
import org.sami.spn.engine.EngineView;
import org.sami.spn.host.HostListener;
import org.sami.spn.host.ListenerList;
import org.sami.spn.host.Registration;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Decision;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.Outcome;
import org.sami.spn.value.DurationValue;
import org.sami.spn.vocabulary.Reserved;

/** The operators of a session: asks all of them, and tells all who answered first. Listens on the engine's thread. */
final class Operators implements HostListener {
    private static final String WORK = "OperatorBackgroundAction";

    private final ListenerList<SessionOperator> operators = new ListenerList<>();
    private final Map<Long, String> planOfMission = new TreeMap<>();
    private final Map<Long, Asked> open = new TreeMap<>();
    private Optional<String> answerer = Optional.empty(); // of the present step

    /** Adds an operator, who is asked what waits already. For the engine's thread, or before the session begins. */
    Registration add(SessionOperator operator) {
        Registration registration = operators.add(operator);
        List.copyOf(open.values()).forEach(operator::asked);
        return registration;
    }

    /** The step that follows is an answer, and gives its author. For the engine's thread. */
    void answeredBy(String author) {
        answerer = Optional.of(author);
    }

    /** Takes up a state that was restored: what its missions run, and what waits in it. */
    void restore(EngineView view, long atMillis) {
        view.missions().forEach(mission -> planOfMission.putIfAbsent(mission.id(), mission.plan()));
        Map<Long, Long> workMillis = new TreeMap<>();
        view.openActivations().forEach(activation -> workMillis.put(activation.id(), workMillis(activation)));
        view.decisions().stream()
                .filter(decision -> !open.containsKey(decision.id()))
                .forEach(decision -> ask(decision, view, workMillis, atMillis));
    }

    @Override
    public void onStep(long index, long atMillis, Input input, List<Effect> effects, EngineView view) {
        Optional<String> by = answerer;
        answerer = Optional.empty();
        Map<Long, Long> workMillis = new TreeMap<>();
        for (Effect effect : effects) {
            if (effect instanceof Effect.MissionStarted started) {
                planOfMission.put(started.mission(), started.plan());
            } else if (effect instanceof Effect.MissionEnded ended && ended.outcome() != Outcome.HALTED) {
                planOfMission.remove(ended.mission()); // its questions are closed
            } else if (effect instanceof Effect.Activated activated) {
                workMillis.put(activated.activation().id(), workMillis(activated.activation()));
            } else if (effect instanceof Effect.DecisionOpened opened) {
                ask(opened.decision(), view, workMillis, atMillis);
            } else if (effect instanceof Effect.DecisionClosed closed && open.remove(closed.decision()) != null) {
                String who = who(input, closed, by);
                operators.each(operator -> operator.settled(closed.decision(), closed.answer(), who));
            }
        }
    }

    private void ask(Decision decision, EngineView view, Map<Long, Long> workMillis, long atMillis) {
        Asked asked = new Asked(
                DecisionPresenter.of(decision, view),
                planOfMission.getOrDefault(decision.mission(), ""),
                workMillis.getOrDefault(decision.activation(), 0L),
                atMillis);
        open.put(decision.id(), asked);
        operators.each(operator -> operator.asked(asked));
    }

    private static String who(Input input, Effect.DecisionClosed closed, Optional<String> by) {
        boolean isItsAnswer = input instanceof Input.AnswerDecision answer && answer.decision() == closed.decision();
        return by.filter(name -> isItsAnswer)
                .orElseGet(() -> closed.by()
                        .map(answerer -> answerer.name().toLowerCase(Locale.ROOT))
                        .orElse(""));
    }

    /** How long the operator is busy with what is asked, besides answering (thesis 8.1). */
    private static long workMillis(Activation activation) {
        return activation.type().equals(WORK)
                        && activation.values().get(Reserved.DURATION) instanceof DurationValue duration
                ? duration.millis()
                : 0;
    }
}
