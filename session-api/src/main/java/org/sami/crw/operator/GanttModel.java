package org.sami.crw.operator;

import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.sami.crw.operator.MissionModel.StartedPlan;
import org.sami.crw.operator.gantt.GanttMission;
import org.sami.crw.operator.gantt.MissionTimes;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Outcome;

/**
 * The missions over time, in the order of their start: when each was in which phase of its plan, and which robot at which place. Follows the engine's
 * effects. Its snapshot is made for listeners, or where the owner's thread asks.
 */
public final class GanttModel extends Model<List<GanttMission>> {
    private static final int ENDED_KEPT = 20;

    private final Map<Long, MissionTimes> missions = new LinkedHashMap<>(); // by root mission
    private final Map<Long, Long> roots = new HashMap<>(); // of missions and sub-missions that run
    private final Map<Long, Long> activations = new HashMap<>(); // root missions by activation
    private final Set<Long> ended = new LinkedHashSet<>();

    GanttModel() {
        super(List.of());
        takeWhenAsked();
    }

    /** One mission over time; empty where it is not known, or no longer. On the owner's thread. */
    public Optional<GanttMission> mission(long id) {
        return Optional.ofNullable(missions.get(id)).map(MissionTimes::chart);
    }

    /** Forgets all. */
    void clear() {
        missions.clear();
        roots.clear();
        activations.clear();
        ended.clear();
        change();
    }

    /**
     * Starts from a restored state.
     *
     * @param marking the effects that give it
     * @param open activations whose visits have not ended
     */
    void restore(
            List<Effect> marking,
            List<Activation> open,
            Map<Long, StartedPlan> plans,
            Map<Long, MissionModel.Earlier> earlier,
            long atMillis) {
        clear();
        Set<Long> touched = new LinkedHashSet<>();
        for (Effect effect : marking) {
            long startedAt = effect instanceof Effect.MissionStarted start && earlier.containsKey(start.mission())
                    ? earlier.get(start.mission()).startedAtMillis().orElse(atMillis)
                    : atMillis;
            apply(effect, plans, startedAt, touched);
        }
        open.forEach(activation -> apply(new Effect.Activated(activation), plans, atMillis, touched));
        touched.forEach(root -> settle(root, atMillis, true));
    }

    /** A step of the engine. */
    void apply(EngineStep step) {
        Set<Long> touched = new LinkedHashSet<>();
        step.effects().forEach(effect -> apply(effect, step.plans(), step.atMillis(), touched));
        touched.forEach(root -> settle(root, step.atMillis(), false));
    }

    private void settle(long root, long atMillis, boolean beganBefore) {
        MissionTimes mission = missions.get(root);
        if (mission != null && !ended.contains(root)) {
            mission.settle(atMillis, beganBefore);
            change();
        }
    }

    private void apply(Effect effect, Map<Long, StartedPlan> plans, long atMillis, Set<Long> touched) {
        if (effect instanceof Effect.MissionStarted e) {
            started(e, plans, atMillis, touched);
        } else if (effect instanceof Effect.Activated e) {
            activations.put(e.activation().id(), e.activation().rootMission());
            tell(e.activation().rootMission(), effect, touched);
        } else if (effect instanceof Effect.ActivationEnded e) {
            tell(activations.getOrDefault(e.activation(), Ids.NONE), effect, touched);
            activations.remove(e.activation());
        } else if (effect instanceof Effect.Entered e) {
            tell(root(e.mission()), effect, touched);
        } else if (effect instanceof Effect.Left e) {
            tell(root(e.mission()), effect, touched);
        } else if (effect instanceof Effect.Fired e) {
            tell(root(e.mission()), effect, touched);
        } else if (effect instanceof Effect.TasksAllocated) {
            missions.keySet().stream()
                    .filter(root -> !ended.contains(root))
                    .toList()
                    .forEach(root -> tell(root, effect, touched));
        } else if (effect instanceof Effect.MissionEnded e && e.outcome() != Outcome.HALTED) {
            ended(e, atMillis, touched);
        }
    }

    private long root(long mission) {
        return roots.getOrDefault(mission, Ids.NONE);
    }

    private void tell(long root, Effect effect, Set<Long> touched) {
        MissionTimes mission = missions.get(root);
        if (mission != null) {
            mission.accept(effect);
            touched.add(root);
        }
    }

    private void started(Effect.MissionStarted e, Map<Long, StartedPlan> plans, long atMillis, Set<Long> touched) {
        StartedPlan started = plans.get(e.mission());
        if (started == null || started.drawn().isEmpty()) {
            return; // its plan is not known here
        }
        StartedPlan.Drawn drawn = started.drawn().get();
        long root = e.parent() == Ids.NONE ? e.mission() : root(e.parent());
        roots.put(e.mission(), root);
        if (e.parent() == Ids.NONE) {
            String title = e.name().isBlank() || e.name().equals(e.plan()) ? started.title() : e.name();
            missions.put(root, new MissionTimes(root, title, drawn.plan(), drawn.chart(), atMillis));
            touched.add(root);
        } else {
            MissionTimes mission = missions.get(root);
            if (mission != null) {
                mission.started(e.mission(), drawn.plan());
            }
        }
    }

    private void ended(Effect.MissionEnded e, long atMillis, Set<Long> touched) {
        long root = root(e.mission());
        tell(root, e, touched);
        roots.remove(e.mission());
        MissionTimes mission = missions.get(e.mission());
        if (mission != null) {
            mission.settle(atMillis, false); // what it did last
            mission.end(atMillis);
            activations.values().removeIf(of -> of == e.mission());
            ended.add(e.mission());
            if (ended.size() > ENDED_KEPT) {
                long oldest = ended.iterator().next();
                ended.remove(oldest);
                missions.remove(oldest);
            }
            change();
        }
    }

    @Override
    List<GanttMission> take() {
        return missions.values().stream().map(MissionTimes::chart).toList();
    }
}
