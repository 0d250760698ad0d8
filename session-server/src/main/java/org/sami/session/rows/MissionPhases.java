package org.sami.session.rows;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.Executor;
import org.sami.spn.engine.EngineView;
import org.sami.spn.host.HostListener;
import org.sami.spn.model.Plan;
import org.sami.spn.phase.PhaseAction;
import org.sami.spn.phase.PhaseChart;
import org.sami.spn.phase.PhaseProgress;
import org.sami.spn.phase.PhaseProgress.Status;
import org.sami.spn.phase.PhaseView;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Input;
import org.sami.spn.vocabulary.Vocabulary;

/**
 * Follows how far each running mission is in the phases of its plan (markups Phase Item and Phase Branch), from its start on. Hears steps on the engine's thread; all
 * else is for the executor's thread.
 */
public final class MissionPhases implements HostListener {
    private static final int MOST_MISSIONS = 200;
    private static final int MOST_ACTIONS = 200; // of a mission

    private final Vocabulary vocabulary;
    private final Executor thread;
    private final Map<Long, Followed> missions = new LinkedHashMap<>();
    private boolean changed = true;
    private Table table = new Table.Builder("phases", MOST_MISSIONS).build();

    private record Followed(PhaseChart chart, PhaseProgress progress) {}

    /**
     * Follows no mission yet.
     *
     * @param thread takes up each step, one after the other
     */
    public MissionPhases(Vocabulary vocabulary, Executor thread) {
        this.vocabulary = vocabulary;
        this.thread = thread;
    }

    @Override
    public void onStep(long index, long atMillis, Input input, List<Effect> effects, EngineView view) {
        if (effects.isEmpty()) {
            return;
        }
        Map<Long, Plan> started = new LinkedHashMap<>();
        for (Effect effect : effects) {
            if (effect instanceof Effect.MissionStarted mission && mission.parent() == Ids.NONE) {
                view.planOf(mission.mission()).ifPresent(plan -> started.put(mission.mission(), plan));
            }
        }
        thread.execute(() -> apply(started, effects));
    }

    private void apply(Map<Long, Plan> started, List<Effect> effects) {
        started.forEach((mission, plan) -> {
            PhaseChart chart = PhaseChart.of(plan, vocabulary);
            if (!chart.isEmpty()) {
                missions.put(mission, new Followed(chart, new PhaseProgress(chart, plan, mission)));
            }
        });
        if (missions.isEmpty()) {
            return;
        }
        missions.values().forEach(followed -> effects.forEach(followed.progress()));
        for (Effect effect : effects) {
            if (effect instanceof Effect.MissionEnded ended) {
                missions.remove(ended.mission());
            }
        }
        changed = true;
    }

    /** A row for each running mission whose plan names phases. */
    Table table() {
        if (changed) {
            changed = false;
            Table.Builder made = new Table.Builder("phases", MOST_MISSIONS);
            missions.forEach((mission, followed) -> fill(made.row(String.valueOf(mission)), followed));
            table = made.build();
        }
        return table;
    }

    private static void fill(ObjectNode row, Followed followed) {
        PhaseProgress progress = followed.progress();
        ArrayNode phases = row.putArray("phases");
        int left = MOST_ACTIONS;
        for (String name : followed.chart().phases()) {
            List<PhaseAction> actions = followed.chart().view(name, progress.taken()).boxes().stream()
                    .map(PhaseView.Box::action)
                    .limit(left)
                    .toList();
            left -= actions.size();
            ObjectNode phase = phases.addObject().put("name", Table.Builder.cut(name));
            phase.put("state", state(actions, progress));
            ArrayNode list = phase.putArray("actions");
            for (PhaseAction action : actions) {
                ObjectNode one = list.addObject()
                        .put("actor", Table.Builder.cut(action.actor()))
                        .put("label", Table.Builder.cut(action.label()))
                        .put("state", BoatRows.word(progress.status(action.id())));
                if (progress.executions(action.id()) > 1) {
                    one.put("times", progress.executions(action.id()));
                }
            }
        }
    }

    /** How a phase stands: {@code active} with an action under way, {@code begun} with some that were, and none now. */
    private static String state(List<PhaseAction> actions, PhaseProgress progress) {
        List<Status> states =
                actions.stream().map(action -> progress.status(action.id())).toList();
        if (states.contains(Status.ACTIVE)) {
            return "active";
        }
        if (!states.contains(Status.DONE)) {
            return "ahead";
        }
        return states.contains(Status.AHEAD) ? "begun" : "done";
    }
}
