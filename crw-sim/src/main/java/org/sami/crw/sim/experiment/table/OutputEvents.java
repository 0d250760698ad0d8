package org.sami.crw.sim.experiment.table;

import java.util.function.BiFunction;
import org.sami.spn.model.OutputEventSpec;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;

/** Changes output events of a project's plans, so that versions of an experiment differ in nothing else. */
final class OutputEvents {
    private OutputEvents() {}

    /**
     * The project with changed output events.
     *
     * @param change gives the event that takes the place of a plan's event, or the same one
     */
    static Project changed(Project project, BiFunction<Plan, OutputEventSpec, OutputEventSpec> change) {
        return project.withPlans(
                project.plans().stream().map(plan -> changed(plan, change)).toList());
    }

    private static Plan changed(Plan plan, BiFunction<Plan, OutputEventSpec, OutputEventSpec> change) {
        return plan.withPlaces(plan.places().stream()
                .map(place -> place.withOutputs(place.outputs().stream()
                        .map(output -> change.apply(plan, output))
                        .toList()))
                .toList());
    }
}
