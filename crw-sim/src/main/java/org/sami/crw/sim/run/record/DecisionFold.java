package org.sami.crw.sim.run.record;

import java.util.ArrayList;
import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalLong;
import org.sami.crw.operator.ClickCount;
import org.sami.crw.operator.mission.EngineText;
import org.sami.crw.report.DecisionResult;
import org.sami.crw.report.RowFormats;
import org.sami.crw.report.SpooledList;
import org.sami.spn.engine.EngineView;
import org.sami.spn.protocol.Answerer;
import org.sami.spn.protocol.Decision;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.Question;

/** What the operator was asked and who answered what, in the order in which it was asked. */
final class DecisionFold implements ReportFold {
    private final Map<Long, Question> questions = new LinkedHashMap<>(); // of those that are open
    private final SpooledList<DecisionResult> settled = new SpooledList<>(RowFormats.DECISION);
    private final Map<Long, DecisionResult> decisions = new LinkedHashMap<>(); // from the first that is open

    @Override
    public void onStep(long index, long atMillis, Input input, List<Effect> effects, EngineView view) {
        for (Effect effect : effects) {
            if (effect instanceof Effect.DecisionOpened opened) {
                opened(atMillis, opened.decision());
            } else if (effect instanceof Effect.DecisionClosed closed) {
                closed(atMillis, closed);
            }
        }
    }

    private void opened(long atMillis, Decision decision) {
        questions.put(decision.id(), decision.question());
        decisions.put(
                decision.id(),
                new DecisionResult(
                        decision.id(),
                        decision.mission(),
                        decision.type(),
                        decision.prompt(),
                        atMillis,
                        OptionalLong.empty(),
                        "",
                        "",
                        0));
    }

    private void closed(long atMillis, Effect.DecisionClosed closed) {
        Question question = questions.remove(closed.decision());
        DecisionResult open = decisions.get(closed.decision());
        if (question == null || open == null) {
            return;
        }
        decisions.put(
                closed.decision(),
                new DecisionResult(
                        open.id(),
                        open.mission(),
                        open.type(),
                        open.prompt(),
                        open.openedAtMillis(),
                        OptionalLong.of(atMillis),
                        closed.by()
                                .map(who -> who.name().toLowerCase(Locale.ROOT))
                                .orElse(""),
                        closed.answer().map(EngineText::answer).orElse(""),
                        clicks(closed, question)));
        settle();
    }

    private static int clicks(Effect.DecisionClosed closed, Question question) {
        return closed.by().equals(Optional.of(Answerer.OPERATOR))
                ? closed.answer()
                        .map(answer -> (int) ClickCount.ofAnswer(answer, question))
                        .orElse(0)
                : 0;
    }

    /** Writes those before the first that is open to a file: nothing more becomes of them. */
    private void settle() {
        Iterator<DecisionResult> oldest = decisions.values().iterator();
        while (oldest.hasNext()) {
            DecisionResult decision = oldest.next();
            if (decision.closedAtMillis().isEmpty()) {
                return;
            }
            settled.add(decision);
            oldest.remove();
        }
    }

    @Override
    public void addTo(ReportDraft report) {
        List<DecisionResult> all = new ArrayList<>(settled);
        all.addAll(decisions.values());
        report.decisions(all);
    }
}
