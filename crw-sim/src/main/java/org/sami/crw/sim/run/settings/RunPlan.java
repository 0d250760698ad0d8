package org.sami.crw.sim.run.settings;

import java.util.Objects;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.vocabulary.Vocabulary;

/** A plan that can be run, with its project and the words that it uses; it has passed the checks. */
public record RunPlan(Vocabulary vocabulary, Project project, Plan plan) {
    public RunPlan {
        Objects.requireNonNull(vocabulary, "vocabulary");
        Objects.requireNonNull(project, "project");
        Objects.requireNonNull(plan, "plan");
    }
}
