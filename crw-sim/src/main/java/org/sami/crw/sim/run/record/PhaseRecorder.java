package org.sami.crw.sim.run.record;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.sami.crw.report.PhaseResult;
import org.sami.crw.report.PhasesPart;
import org.sami.spn.engine.EngineView;
import org.sami.spn.model.Plan;
import org.sami.spn.phase.PhaseAction;
import org.sami.spn.phase.PhaseChart;
import org.sami.spn.phase.PhaseProgress;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Input;
import org.sami.spn.vocabulary.Vocabulary;

/** Follows the missions on the phase charts of their plans, for the report. Plans without a chart are left out. */
final class PhaseRecorder implements ReportFold {
    /** Most missions of a report; nobody would read more. */
    private static final int MOST_MISSIONS = 1000;

    private final Vocabulary vocabulary;
    private final Map<Long, Followed> missions = new LinkedHashMap<>();

    private record Followed(String plan, PhaseChart chart, PhaseProgress progress) {}

    /** For plans in one vocabulary. */
    PhaseRecorder(Vocabulary vocabulary) {
        this.vocabulary = vocabulary;
    }

    @Override
    public void onStep(long index, long atMillis, Input input, List<Effect> effects, EngineView view) {
        for (Effect effect : effects) {
            if (effect instanceof Effect.MissionStarted started && missions.size() < MOST_MISSIONS) {
                view.plan(started.plan()).ifPresent(plan -> follow(started.mission(), plan));
            }
            missions.values().forEach(mission -> mission.progress().accept(effect));
        }
    }

    private void follow(long mission, Plan plan) {
        PhaseChart chart = PhaseChart.of(plan, vocabulary);
        if (!chart.isEmpty()) {
            missions.put(mission, new Followed(plan.id(), chart, new PhaseProgress(chart, plan, mission)));
        }
    }

    @Override
    public void addTo(ReportDraft report) {
        report.add(new PhasesPart(results()));
    }

    /** The present state of the actions of all charts. */
    private List<PhaseResult> results() {
        List<PhaseResult> results = new ArrayList<>();
        missions.forEach((id, mission) -> {
            for (PhaseAction action : mission.chart().actions()) {
                results.add(new PhaseResult(
                        id,
                        mission.plan(),
                        action.phase(),
                        action.actor(),
                        action.label(),
                        mission.progress().status(action.id()).name().toLowerCase(Locale.ROOT),
                        mission.progress().executions(action.id())));
            }
        });
        return results;
    }
}
