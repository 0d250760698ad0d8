package org.sami.spn.phase;

import java.util.Collections;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Objects;
import java.util.function.Consumer;
import org.sami.spn.model.InputEventSpec;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Transition;
import org.sami.spn.protocol.Effect;

/**
 * What one mission has done of its plan's phase chart, followed from effects from the mission's start on. Used by one thread at a
 * time.
 */
public final class PhaseProgress implements Consumer<Effect> {
    /** How an action stands. */
    public enum Status {
        /** It has not been executed yet. */
        AHEAD,
        /** It is under way, for the first time or again. */
        ACTIVE,
        /** It has been executed. */
        DONE
    }

    private final PhaseChart chart;
    private final Plan plan;
    private final long mission;
    private final Map<String, Integer> executed = new HashMap<>();
    private final Map<String, Integer> active = new HashMap<>();
    private final Map<Long, String> activations = new HashMap<>();
    private final Map<String, String> taken = new LinkedHashMap<>();

    /**
     * The progress of a mission that has done nothing yet.
     *
     * @param plan of which the chart is
     */
    public PhaseProgress(PhaseChart chart, Plan plan, long mission) {
        this.chart = Objects.requireNonNull(chart, "chart");
        this.plan = Objects.requireNonNull(plan, "plan");
        this.mission = mission;
    }

    /** Takes the next effect; those of other missions change nothing. */
    @Override
    public void accept(Effect effect) {
        if (effect instanceof Effect.Activated e && e.activation().mission() == mission) {
            begin(e.activation().id(), e.activation().event());
        } else if (effect instanceof Effect.ActivationEnded e) {
            end(e.activation());
        } else if (effect instanceof Effect.Fired e && e.mission() == mission) {
            plan.transition(e.transition()).ifPresent(transition -> fired(transition, e));
        } else if (effect instanceof Effect.MissionEnded e && e.mission() == mission) {
            activations.clear();
            active.clear();
        }
    }

    private void begin(long activation, String event) {
        if (chart.action(event).isPresent()) {
            execute(event);
            activations.put(activation, event);
            active.merge(event, 1, Integer::sum);
        }
    }

    private void end(long activation) {
        String event = activations.remove(activation);
        if (event != null) {
            active.computeIfPresent(event, (e, count) -> count == 1 ? null : count - 1);
        }
    }

    private void fired(Transition transition, Effect.Fired firing) {
        for (InputEventSpec input : transition.inputs()) {
            boolean used = firing.used().stream()
                    .anyMatch(occurrence -> occurrence.type().equals(input.type()));
            if (used && chart.action(input.id()).isPresent()) {
                execute(input.id());
            }
        }
    }

    private void execute(String action) {
        executed.merge(action, 1, Integer::sum);
        for (PhaseAction item : chart.actions()) {
            if (chart.options(item.id()).stream().anyMatch(option -> option.id().equals(action))) {
                taken.put(item.id(), action);
            }
        }
    }

    /** How an action stands. */
    public Status status(String action) {
        if (active.containsKey(action)) {
            return Status.ACTIVE;
        }
        return executed.containsKey(action) ? Status.DONE : Status.AHEAD;
    }

    /** How often an action was begun. */
    public int executions(String action) {
        return executed.getOrDefault(action, 0);
    }

    /** The options that were taken last, by the action that has them: what {@link PhaseChart#view} is to show. */
    public Map<String, String> taken() {
        return Collections.unmodifiableMap(new LinkedHashMap<>(taken));
    }
}
