package org.sami.crw.sim.run.record;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.sami.crw.operator.mission.EngineText;
import org.sami.crw.report.FiringResult;
import org.sami.crw.report.RowFormats;
import org.sami.crw.report.SpooledList;
import org.sami.spn.engine.EngineView;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.Outcome;

/** All firings in order; most of them are kept in a file. */
final class FiringFold implements ReportFold {
    private final Project project;
    private final Map<Long, String> planOfMission = new HashMap<>();
    private final SpooledList<FiringResult> firings = new SpooledList<>(RowFormats.FIRING);

    FiringFold(Project project) {
        this.project = project;
    }

    @Override
    public void onStep(long index, long atMillis, Input input, List<Effect> effects, EngineView view) {
        for (Effect effect : effects) {
            if (effect instanceof Effect.MissionStarted started) {
                planOfMission.put(started.mission(), started.plan());
            } else if (effect instanceof Effect.Fired fired) {
                firings.add(firing(index, atMillis, fired));
            } else if (effect instanceof Effect.MissionEnded ended && ended.outcome() != Outcome.HALTED) {
                planOfMission.remove(ended.mission()); // a transition that never fires again
            }
        }
    }

    private FiringResult firing(long index, long atMillis, Effect.Fired fired) {
        String planId = planOfMission.getOrDefault(fired.mission(), "");
        Optional<Plan> plan = project.plan(planId);
        return new FiringResult(
                fired.firing(),
                index,
                atMillis,
                fired.mission(),
                planId,
                plan.map(known -> EngineText.transition(known, fired.transition()))
                        .orElse(fired.transition()),
                EngineText.occurrences(fired.used()),
                plan.map(known -> EngineText.moves(known, fired.moves())).orElse(""));
    }

    @Override
    public void addTo(ReportDraft report) {
        report.firings(firings.soFar());
    }
}
