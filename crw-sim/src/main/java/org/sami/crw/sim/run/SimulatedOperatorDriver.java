package org.sami.crw.sim.run;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.function.Consumer;
import org.sami.crw.decision.BoatFilter;
import org.sami.crw.decision.SimulatedOperator;
import org.sami.crw.session.Scheduler;
import org.sami.crw.sim.report.NoteResult;
import org.sami.spn.engine.EngineView;
import org.sami.spn.finding.Finding;
import org.sami.spn.host.EngineHost;
import org.sami.spn.host.HostListener;
import org.sami.spn.json.Reading;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Answer;
import org.sami.spn.protocol.Answerer;
import org.sami.spn.protocol.Decision;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.Outcome;
import org.sami.spn.value.DurationValue;
import org.sami.spn.vocabulary.Reserved;

/** Where the simulated operator sits: sees a decision when it opens, answers it a while later. */
public final class SimulatedOperatorDriver implements HostListener {
    private static final String WORK = "OperatorBackgroundAction";

    private final SimulatedOperator operator;
    private final Scheduler clock;
    private final long answerAfterMillis;
    private final Map<Long, String> planOfMission = new TreeMap<>();
    private final Map<Long, Decision> open = new TreeMap<>();
    private final Map<Long, Long> work =
            new TreeMap<>(); // milliseconds that it takes beside answering, by open decision
    private final List<NoteResult> troubles = new ArrayList<>();
    private final Set<Long> thinkingOf = new HashSet<>();
    private Consumer<Input> door = input -> {}; // while the past of a run is gone through, it has been answered already

    /**
     * An operator who has not been asked yet.
     *
     * @param answerAfterMillis how long every answer takes; what is work takes its own time beside
     */
    public SimulatedOperatorDriver(SimulatedOperator operator, Scheduler clock, long answerAfterMillis) {
        this.operator = operator;
        this.clock = clock;
        this.answerAfterMillis = answerAfterMillis;
    }

    /**
     * Tells it whom to answer; before the first decision, or when the past of the run has been gone through. What was answered there
     * and is open all the same is answered once more.
     */
    public void connect(EngineHost answered) {
        door = answered::post;
        open().stream().filter(decision -> !thinkingOf.contains(decision.id())).forEach(this::think);
    }

    @Override
    public void onStep(long index, long atMillis, Input input, List<Effect> effects, EngineView view) {
        Map<Long, Long> workMillis = new TreeMap<>();
        for (Effect effect : effects) {
            if (effect instanceof Effect.MissionStarted started) {
                planOfMission.put(started.mission(), started.plan());
            } else if (effect instanceof Effect.MissionEnded ended && ended.outcome() != Outcome.HALTED) {
                planOfMission.remove(ended.mission()); // its questions are closed
            } else if (effect instanceof Effect.Activated activated) {
                workMillis.put(activated.activation().id(), workMillis(activated.activation()));
            } else if (effect instanceof Effect.DecisionOpened opened) {
                Decision decision = BoatFilter.narrowed(opened.decision(), view);
                open.put(decision.id(), decision);
                work.put(decision.id(), workMillis.getOrDefault(decision.activation(), 0L));
                think(decision);
            } else if (effect instanceof Effect.DecisionClosed closed) {
                open.remove(closed.decision());
                work.remove(closed.decision());
            }
        }
    }

    /** How long the operator is busy with what is asked, beside answering (thesis 8.1). */
    private static long workMillis(Activation activation) {
        return activation.type().equals(WORK)
                        && activation.values().get(Reserved.DURATION) instanceof DurationValue duration
                ? duration.millis()
                : 0;
    }

    private void think(Decision decision) {
        thinkingOf.add(decision.id());
        clock.after(answerAfterMillis + work.get(decision.id()), () -> {
            thinkingOf.remove(decision.id());
            if (open.containsKey(decision.id())) {
                answer(decision);
            }
        });
    }

    private void answer(Decision decision) {
        Reading<Answer> answer = operator.answer(decision, planOfMission.getOrDefault(decision.mission(), ""));
        for (Finding finding : answer.findings()) {
            String text = finding.pointer().isEmpty()
                    ? finding.message()
                    : "answers file, " + finding.pointer() + ": " + finding.message();
            troubles.add(new NoteResult(clock.nowMs(), NoteResult.UNANSWERED, decision.mission(), text));
        }
        answer.result().ifPresent(a -> door.accept(new Input.AnswerDecision(decision.id(), a, Answerer.OPERATOR)));
    }

    /** Whether an answer will be given without anything else happening. */
    public boolean isThinking() {
        return !thinkingOf.isEmpty();
    }

    /** Questions that nobody has answered yet, in order. */
    public List<Decision> open() {
        return List.copyOf(open.values());
    }

    /** What the operator could not answer, in words, oldest first. */
    public List<String> troubles() {
        return troubles.stream().map(NoteResult::message).toList();
    }

    /** The same with their times. */
    public List<NoteResult> notes() {
        return troubles;
    }
}
