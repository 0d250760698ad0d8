package org.sami.crw.sim.run.settings;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Objects;
import org.sami.crw.decision.AnswersFile;
import org.sami.spn.value.Value;

/**
 * All that a run is put together of, on whatever fleet.
 *
 * @param answers what the simulated operator is told to answer
 * @param parameters values for what the plan asks at its start
 */
public record RunInput(RunPlan plan, RunSettings settings, AnswersFile answers, Map<String, Value> parameters) {
    public RunInput {
        Objects.requireNonNull(plan, "plan");
        Objects.requireNonNull(settings, "settings");
        Objects.requireNonNull(answers, "answers");
        parameters = Collections.unmodifiableMap(new LinkedHashMap<>(parameters));
    }

    /**
     * A run with the parameters of its settings.
     *
     * @throws IllegalArgumentException naming the parameter, if a given one does not fit the plan
     */
    public static RunInput of(RunPlan plan, RunSettings settings, AnswersFile answers) {
        return new RunInput(
                plan,
                settings,
                answers,
                new Parameters(plan.vocabulary(), plan.project(), plan.plan()).read(settings.parameters()));
    }
}
