package org.sami.crw.operator;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import org.sami.crw.markup.MarkedEvent;
import org.sami.spn.engine.EngineView;
import org.sami.spn.model.InputEventSpec;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Transition;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Occurrence;
import org.sami.spn.protocol.Outcome;

/**
 * The plan of each mission, kept until the step in which the mission ends is over: the engine no longer has it then. For the engine's
 * thread.
 */
final class RunningPlans {
    private final Map<Long, Plan> plans = new HashMap<>();

    /** Knows the missions of a state. */
    void restore(EngineView view) {
        plans.clear();
        view.missions().forEach(mission -> view.planOf(mission.id()).ifPresent(plan -> plans.put(mission.id(), plan)));
    }

    /** Missions have started. */
    void before(List<Effect> effects, EngineView view) {
        for (Effect effect : effects) {
            if (effect instanceof Effect.MissionStarted started) {
                view.planOf(started.mission())
                        .or(() -> view.plan(started.plan()))
                        .ifPresent(plan -> plans.put(started.mission(), plan));
            }
        }
    }

    /** Missions have ended. */
    void after(List<Effect> effects) {
        for (Effect effect : effects) {
            if (effect instanceof Effect.MissionEnded ended && ended.outcome() != Outcome.HALTED) {
                plans.remove(ended.mission());
            }
        }
    }

    Optional<Plan> of(long mission) {
        return Optional.ofNullable(plans.get(mission));
    }

    /** The input events with markup that a firing used up. */
    List<MarkedEvent> received(Effect.Fired fired) {
        List<MarkedEvent> marked = new ArrayList<>();
        Optional<Transition> transition = of(fired.mission())
                .flatMap(plan -> plan.transitions().stream()
                        .filter(one -> one.id().equals(fired.transition()))
                        .findFirst());
        if (transition.isPresent() && !fired.used().isEmpty()) {
            for (InputEventSpec input : transition.get().inputs()) {
                List<Occurrence> used = fired.used().stream()
                        .filter(one -> one.type().equals(input.type()))
                        .toList();
                if (!used.isEmpty() && !input.markups().isEmpty()) {
                    marked.add(marked(fired.mission(), input, used));
                }
            }
        }
        return marked;
    }

    private MarkedEvent marked(long mission, InputEventSpec input, List<Occurrence> used) {
        return new MarkedEvent(
                Ids.NONE,
                mission,
                Objects.requireNonNull(plans.get(mission), () -> "mission " + mission + " has no plan")
                                .id() + "/" + input.id(),
                input.type(),
                input.markups(),
                used.stream().flatMap(one -> one.proxies().stream()).distinct().toList());
    }
}
