package org.sami.crw.sim.run.operator;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.concurrent.ConcurrentHashMap;
import org.sami.crw.decision.SimulatedOperator;
import org.sami.crw.operator.DecisionQueue;
import org.sami.crw.operator.decision.PendingDecision;
import org.sami.crw.report.NoteResult;
import org.sami.crw.session.Scheduler;
import org.sami.crw.session.Session;
import org.sami.crw.session.SessionOperator;
import org.sami.spn.engine.EngineView;
import org.sami.spn.finding.Finding;
import org.sami.spn.json.Reading;
import org.sami.spn.protocol.Answer;
import org.sami.spn.protocol.Decision;
import org.sami.spn.value.GeoPoint;

/**
 * Lets the simulated operator answer a session's decisions, each after a delay, as the operator's models show them then. If several are due it
 * answers the first one of the queue: by priority, then by age (docs/answers-file.md). For the engine's thread.
 */
public final class SimulatedOperatorDriver implements SessionOperator {
    public static final String NAME = "simulated operator";

    /** A decision that was asked appears in the models within this time. */
    private static final long NOT_SHOWN_MILLIS = 20;

    /** Asks for manual work, partly on boats. */
    private static final String WORK = "OperatorBackgroundAction";

    /** Interval at which an operator who works checks whether the work is done. */
    private static final long POLL_MILLIS = 500;

    private static final Comparator<Asked> IN_TURN = DecisionQueue.order(Asked::decision, Asked::atMillis);

    private final AnswerSource answers;
    private final Scheduler clock;
    private final long answerAfterMillis;
    private final GeoPoint quay;
    private final Map<Long, Asked> open = new TreeMap<>();
    private final List<NoteResult> troubles = new ArrayList<>();
    private final Map<Long, Long> thinkingUntil = new HashMap<>();
    private final Set<Long> onTheirWay = ConcurrentHashMap.newKeySet(); // answers that the engine has not taken yet
    private Optional<Session> session =
            Optional.empty(); // none while the past of a run is repeated: its answers are in it

    /**
     * An operator without questions yet.
     *
     * @param answerAfterMillis delay of each answer, in ms; manual work such as a battery swap adds its own duration, and a swap ends when the batteries are in
     * @param quay where they are
     */
    public SimulatedOperatorDriver(SimulatedOperator operator, Scheduler clock, long answerAfterMillis, GeoPoint quay) {
        this((AnswerSource) operator::answer, clock, answerAfterMillis, quay);
    }

    /**
     * An operator whose answers come from elsewhere.
     *
     * @param answers what is answered, and what delays it further
     * @param answerAfterMillis delay of each answer, in ms, as above
     * @param quay where batteries are changed
     */
    public SimulatedOperatorDriver(AnswerSource answers, Scheduler clock, long answerAfterMillis, GeoPoint quay) {
        this.answers = answers;
        this.clock = clock;
        this.answerAfterMillis = answerAfterMillis;
        this.quay = quay;
    }

    /**
     * Connects it to the session: before the first decision, or after the past of the run has been repeated. Decisions that are still open there are
     * answered again.
     */
    public void connect(Session answered) {
        session = Optional.of(answered);
        open.values().stream()
                .filter(asked -> !thinkingUntil.containsKey(asked.decision().id()))
                .forEach(this::think);
    }

    @Override
    public String name() {
        return NAME;
    }

    @Override
    public void asked(Asked asked) {
        open.put(asked.decision().id(), asked);
        think(asked);
    }

    @Override
    public void settled(long decision, Optional<Answer> answer, String by) {
        open.remove(decision);
    }

    private void think(Asked asked) {
        thinkFor(asked, answerAfterMillis + asked.workMillis() + answers.furtherMillis(asked));
    }

    private void thinkFor(Asked asked, long millis) {
        thinkingUntil.put(asked.decision().id(), clock.nowMs() + millis);
        clock.after(millis, this::answerNext);
    }

    /** Answers one decision that is due: the first one in the operator's queue. */
    private void answerNext() {
        thinkingUntil.keySet().retainAll(open.keySet());
        List<Asked> ready = open.values().stream()
                .filter(asked -> thinkingUntil.getOrDefault(asked.decision().id(), Long.MAX_VALUE) <= clock.nowMs())
                .sorted(IN_TURN)
                .toList();
        Optional<Asked> next =
                ready.stream().filter(asked -> plan(asked).isPresent()).findFirst();
        if (next.isEmpty()) {
            if (!ready.isEmpty()) {
                clock.after(NOT_SHOWN_MILLIS, this::answerNext);
            }
        } else if (isStillAtWork(next.get())) {
            thinkFor(next.get(), POLL_MILLIS);
        } else {
            thinkingUntil.remove(next.get().decision().id());
            answer(next.get().decision(), plan(next.get()).orElseThrow());
        }
    }

    /** The asking plan, once its decision is shown; its own quay and area take precedence over what is proposed. */
    private Optional<String> plan(Asked asked) {
        return session.isEmpty()
                ? Optional.of(asked.plan())
                : session.get().models().decisions().find(asked.decision().id()).map(PendingDecision::plan);
    }

    /** Whether work on boats, such as changing batteries, is not done yet. */
    private boolean isStillAtWork(Asked asked) {
        Decision decision = asked.decision();
        return session.isPresent()
                && decision.type().equals(WORK)
                && new BatterySwaps(session.get().fleet().history(), quay)
                        .areUnderWay(
                                session.get().host().ask(view -> boatsOf(decision, view)),
                                clock.nowMs() - asked.atMillis());
    }

    private static List<String> boatsOf(Decision decision, EngineView view) {
        return view.openActivations().stream()
                .filter(activation -> activation.id() == decision.activation())
                .flatMap(activation -> activation.proxies().stream())
                .toList();
    }

    private void answer(Decision decision, String plan) {
        Reading<Answer> answer = answers.answer(decision, plan);
        for (Finding finding : answer.findings()) {
            String text = finding.pointer().isEmpty()
                    ? finding.message()
                    : "answers file, " + finding.pointer() + ": " + finding.message();
            troubles.add(new NoteResult(clock.nowMs(), NoteResult.UNANSWERED, decision.mission(), text));
        }
        answer.result().ifPresent(given -> session.ifPresent(asking -> give(asking, decision.id(), given)));
    }

    private void give(Session asking, long decision, Answer answer) {
        onTheirWay.add(decision);
        asking.answer(decision, answer, NAME).whenComplete((taken, refused) -> onTheirWay.remove(decision));
    }

    /** Whether an answer will be given without anything else happening, or has been given and not been taken yet. */
    public boolean isThinking() {
        return !thinkingUntil.isEmpty() || !onTheirWay.isEmpty();
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
