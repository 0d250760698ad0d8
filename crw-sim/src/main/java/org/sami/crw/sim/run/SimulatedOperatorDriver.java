package org.sami.crw.sim.run;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import org.sami.crw.decision.SimulatedOperator;
import org.sami.crw.operator.PendingDecision;
import org.sami.crw.session.Scheduler;
import org.sami.crw.session.Session;
import org.sami.crw.session.SessionOperator;
import org.sami.crw.sim.report.NoteResult;
import org.sami.spn.engine.EngineView;
import org.sami.spn.finding.Finding;
import org.sami.spn.json.Reading;
import org.sami.spn.protocol.Answer;
import org.sami.spn.protocol.Decision;
import org.sami.spn.value.GeoPoint;

/**
 * Lets the simulated operator answer a session's decisions, each a while after it was asked, as they lie in the operator's models then.
 * For the engine's thread.
 */
public final class SimulatedOperatorDriver implements SessionOperator {
    static final String NAME = "simulated operator";

    /** A decision that is asked and not shown yet is shown within this. */
    private static final long NOT_SHOWN_MILLIS = 20;

    /** Asks for work, of which some is done on boats. */
    private static final String WORK = "OperatorBackgroundAction";

    /** How often somebody who works looks whether it is done. */
    private static final long LOOK_MILLIS = 500;

    private final SimulatedOperator operator;
    private final Scheduler clock;
    private final long answerAfterMillis;
    private final GeoPoint quay;
    private final Map<Long, Asked> open = new TreeMap<>();
    private final List<NoteResult> troubles = new ArrayList<>();
    private final Set<Long> thinkingOf = new HashSet<>();
    private Optional<Session> session =
            Optional.empty(); // none while the past of a run is gone through: it was answered

    /**
     * An operator who has not been asked yet.
     *
     * @param answerAfterMillis how long every answer takes; what is work takes its own time beside, and where batteries are swapped ends when they are in
     * @param quay where they are
     */
    public SimulatedOperatorDriver(SimulatedOperator operator, Scheduler clock, long answerAfterMillis, GeoPoint quay) {
        this.operator = operator;
        this.clock = clock;
        this.answerAfterMillis = answerAfterMillis;
        this.quay = quay;
    }

    /**
     * Tells it whom to answer; before the first decision, or when the past of the run has been gone through. What was answered there
     * and is open all the same is answered once more.
     */
    public void connect(Session answered) {
        session = Optional.of(answered);
        open.values().stream()
                .filter(asked -> !thinkingOf.contains(asked.decision().id()))
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
        long decision = asked.decision().id();
        thinkingOf.add(decision);
        clock.after(answerAfterMillis + asked.workMillis(), () -> answerIfShown(asked));
    }

    private void answerIfShown(Asked asked) {
        long decision = asked.decision().id();
        if (!open.containsKey(decision)) {
            thinkingOf.remove(decision);
        } else if (session.isEmpty()) {
            thinkingOf.remove(decision);
            answer(asked.decision(), asked.plan());
        } else {
            Optional<PendingDecision> shown = session.get().models().decisions().find(decision);
            if (shown.isEmpty()) {
                clock.after(NOT_SHOWN_MILLIS, () -> answerIfShown(asked));
            } else if (isStillAtWork(session.get(), asked)) {
                clock.after(LOOK_MILLIS, () -> answerIfShown(asked));
            } else {
                thinkingOf.remove(decision);
                answer(asked.decision(), shown.get().plan()); // it knows its own quay and area, whatever is proposed
            }
        }
    }

    private boolean isStillAtWork(Session asking, Asked asked) {
        Decision decision = asked.decision();
        return decision.type().equals(WORK)
                && new BatterySwaps(asking.fleet().history(), quay)
                        .areUnderWay(
                                asking.host().ask(view -> boatsOf(decision, view)), clock.nowMs() - asked.atMillis());
    }

    private static List<String> boatsOf(Decision decision, EngineView view) {
        return view.openActivations().stream()
                .filter(activation -> activation.id() == decision.activation())
                .flatMap(activation -> activation.proxies().stream())
                .toList();
    }

    private void answer(Decision decision, String plan) {
        Reading<Answer> answer = operator.answer(decision, plan);
        for (Finding finding : answer.findings()) {
            String text = finding.pointer().isEmpty()
                    ? finding.message()
                    : "answers file, " + finding.pointer() + ": " + finding.message();
            troubles.add(new NoteResult(clock.nowMs(), NoteResult.UNANSWERED, decision.mission(), text));
        }
        answer.result().ifPresent(a -> session.ifPresent(asking -> asking.answer(decision.id(), a, NAME)));
    }

    /** Whether an answer will be given without anything else happening. */
    public boolean isThinking() {
        return !thinkingOf.isEmpty();
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
