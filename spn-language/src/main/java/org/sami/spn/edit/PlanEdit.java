package org.sami.spn.edit;

import java.util.ArrayList;
import java.util.List;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;

/** A change of one plan. */
public interface PlanEdit extends Edit {
    /** The id of the plan. */
    String plan();

    /**
     * Changes the plan.
     *
     * @throws EditRefusedException with one sentence on what is not possible and where
     */
    Plan change(Plan plan, EditContext context) throws EditRefusedException;

    @Override
    default Project change(Project project, EditContext context) throws EditRefusedException {
        List<Plan> plans = new ArrayList<>(project.plans());
        for (int i = 0; i < plans.size(); i++) {
            if (plans.get(i).id().equals(plan())) {
                plans.set(i, change(plans.get(i), context));
                return project.withPlans(plans);
            }
        }
        throw new EditRefusedException("The project has no plan \"" + plan() + "\"");
    }
}
