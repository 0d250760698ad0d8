package org.sami.crw.sim.experiment;

import java.util.Objects;
import org.sami.crw.decision.AnswersFile;
import org.sami.crw.sim.run.settings.RunPlan;
import org.sami.crw.sim.run.settings.RunSettings;

/**
 * A mission that an experiment runs again and again.
 *
 * @param label what tables call it
 * @param settings of its runs; the experiment sets seed and conditions
 */
public record ExperimentCase(String label, RunPlan plan, RunSettings settings, AnswersFile answers) {
    public ExperimentCase {
        Objects.requireNonNull(label, "label");
        Objects.requireNonNull(plan, "plan");
        Objects.requireNonNull(answers, "answers");
        if (settings.isConnected()) {
            throw new IllegalArgumentException("an experiment runs on boats of its own process");
        }
    }
}
