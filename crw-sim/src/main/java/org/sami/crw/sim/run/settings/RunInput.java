package org.sami.crw.sim.run.settings;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Objects;
import org.sami.crw.decision.AnswersFile;

/**
 * All that a run is put together of, on whatever fleet.
 *
 * @param plan of the first mission, with its project
 * @param answers the rules of the simulated operator's answers
 * @param missions what the run starts, by time; the first when all boats are there. The run is over when all of them are
 */
public record RunInput(RunPlan plan, RunSettings settings, AnswersFile answers, List<PlannedMission> missions) {
    public RunInput {
        Objects.requireNonNull(plan, "plan");
        Objects.requireNonNull(settings, "settings");
        Objects.requireNonNull(answers, "answers");
        missions = List.copyOf(missions);
        if (missions.isEmpty()) {
            throw new IllegalArgumentException("a run has a mission");
        }
    }

    /**
     * A run of what its settings say.
     *
     * @throws IllegalArgumentException naming the parameter or the mission, if one does not fit the plan or the project
     */
    public static RunInput of(RunPlan plan, RunSettings settings, AnswersFile answers) {
        List<PlannedMission> missions = new ArrayList<>();
        missions.add(new PlannedMission(
                plan.plan(),
                settings.mission(),
                new Parameters(plan.vocabulary(), plan.project(), plan.plan()).read(settings.parameters()),
                0));
        settings.also().stream()
                .map(more -> PlannedMission.parse(more, plan.vocabulary(), plan.project()))
                .sorted(Comparator.comparingLong(PlannedMission::afterMillis))
                .forEach(missions::add);
        return new RunInput(plan, settings, answers, missions);
    }

    /** The interrupts that its missions offer. */
    public PlanInterrupts interrupts() {
        return new PlanInterrupts(
                plan.vocabulary(),
                plan.project(),
                missions.stream().map(PlannedMission::plan).toList());
    }
}
