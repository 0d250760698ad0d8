package org.sami.crw.gui.mission;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.LongConsumer;
import org.sami.spn.engine.EngineView;
import org.sami.spn.host.HostListener;
import org.sami.spn.model.Plan;
import org.sami.spn.phase.PhaseChart;
import org.sami.spn.phase.PhaseProgress;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Input;
import org.sami.spn.vocabulary.Vocabulary;
import org.sami.ui.EventThread;

/** Follows what each mission has done of the phases of its plan. Hears effects on the engine's thread, and changes on the event thread only. */
final class PhaseFollower implements HostListener {
    private final Vocabulary vocabulary;
    private final LongConsumer changed;
    private final Map<Long, Phases> missions = new HashMap<>();

    /** The phases of one mission: the chart of its plan, and how far it is. */
    record Phases(PhaseChart chart, PhaseProgress progress) {}

    /**
     * Follows no mission yet.
     *
     * @param changed receives of a mission that has gone on, on the event thread
     */
    PhaseFollower(Vocabulary vocabulary, LongConsumer changed) {
        this.vocabulary = vocabulary;
        this.changed = changed;
    }

    /** The phases of a mission; empty where its plan names none, or it began before this window. */
    Optional<Phases> of(long mission) {
        return Optional.ofNullable(missions.get(mission));
    }

    @Override
    public void onStep(long index, long atMillis, Input input, List<Effect> effects, EngineView view) {
        if (effects.isEmpty()) {
            return;
        }
        Map<Long, Plan> started = new HashMap<>();
        for (Effect effect : effects) {
            if (effect instanceof Effect.MissionStarted mission && mission.parent() == Ids.NONE) {
                view.planOf(mission.mission()).ifPresent(plan -> started.put(mission.mission(), plan));
            }
        }
        EventThread.later(() -> apply(started, effects));
    }

    private void apply(Map<Long, Plan> started, List<Effect> effects) {
        started.forEach((mission, plan) -> {
            PhaseChart chart = PhaseChart.of(plan, vocabulary);
            if (!chart.isEmpty()) {
                missions.put(mission, new Phases(chart, new PhaseProgress(chart, plan, mission)));
            }
        });
        missions.forEach((mission, phases) -> {
            effects.forEach(phases.progress());
            changed.accept(mission);
        });
    }
}
