package org.sami.crw.operator.gantt;

import java.util.HashMap;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.OptionalLong;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;
import org.sami.spn.phase.PhaseChart;
import org.sami.spn.protocol.Effect;

/** Follows one mission over time from the effects that concern it and its sub-missions. For one thread at a time. */
public final class MissionTimes {
    private final long id;
    private final String title;
    private final long startedAtMillis;
    private final Map<Long, Plan> plans = new HashMap<>();
    private final PhaseTimes phases;
    private final RobotTimes robots = new RobotTimes();
    private OptionalLong endedAtMillis = OptionalLong.empty();
    private Optional<GanttMission> made = Optional.empty();

    /**
     * A mission that has just started.
     *
     * @param title what people call it
     * @param chart of its plan
     * @param startedAtMillis on the session's clock
     */
    public MissionTimes(long id, String title, Plan plan, PhaseChart chart, long startedAtMillis) {
        this.id = id;
        this.title = Objects.requireNonNull(title, "title");
        this.startedAtMillis = startedAtMillis;
        plans.put(id, plan);
        phases = new PhaseTimes(plan, chart, id);
    }

    /** A sub-mission of it has started. */
    public void started(long subMission, Plan plan) {
        plans.put(subMission, plan);
    }

    /** Takes the next effect of this mission or a sub-mission. */
    public void accept(Effect effect) {
        if (effect instanceof Effect.Entered e) {
            robots.entered(e, place(e.mission(), e.place()));
        } else if (effect instanceof Effect.Left e) {
            robots.left(e);
        } else if (effect instanceof Effect.TasksAllocated e) {
            robots.allocated(e.robots());
        } else if (effect instanceof Effect.MissionEnded e) {
            robots.ended(e.mission());
        }
        phases.accept(effect);
        made = Optional.empty();
    }

    private Optional<Place> place(long mission, String place) {
        return Optional.ofNullable(plans.get(mission)).flatMap(plan -> plan.place(place));
    }

    /**
     * The effects of one step have been taken: what is so now counts from its time on.
     *
     * @param beganBefore whether it was so earlier, before this program followed the session
     */
    public void settle(long atMillis, boolean beganBefore) {
        phases.settle(atMillis, beganBefore);
        robots.settle(atMillis, beganBefore);
        made = Optional.empty();
    }

    /** It is over. */
    public void end(long atMillis) {
        endedAtMillis = OptionalLong.of(atMillis);
        phases.end(atMillis);
        robots.end(atMillis);
        made = Optional.empty();
    }

    /** It over time, until now. */
    public GanttMission chart() {
        GanttMission now = made.orElseGet(() -> new GanttMission(
                id,
                title,
                startedAtMillis,
                endedAtMillis,
                phases.phases(),
                robots.rows(),
                phases.chart(),
                phases.taken()));
        made = Optional.of(now);
        return now;
    }
}
