package org.sami.crw.sim.run.settings;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Objects;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.value.Value;

/**
 * A root mission that a run starts.
 *
 * @param name of the mission
 * @param parameters values for what the plan asks at its start
 * @param afterMillis how long after the first mission of the run, in simulated milliseconds; 0 for the first
 */
public record PlannedMission(Plan plan, String name, Map<String, Value> parameters, long afterMillis) {
    private static final char AT = '@';

    public PlannedMission {
        Objects.requireNonNull(plan, "plan");
        Objects.requireNonNull(name, "name");
        parameters = Collections.unmodifiableMap(new LinkedHashMap<>(parameters));
        if (afterMillis < 0 || afterMillis > RunSettings.LONGEST_MILLIS) {
            throw new IllegalArgumentException(
                    "a mission starts 0 to 86400 s after the first, not " + afterMillis / 1000.0);
        }
    }

    /**
     * Reads {@code PLAN[@SECONDS]}: a mission of another plan of the project, or of the same once more, which asks for what it needs.
     *
     * @throws IllegalArgumentException if the project has no such plan, or the time makes no sense
     */
    public static PlannedMission parse(String text, Project project) {
        int at = text.lastIndexOf(AT);
        String id = at < 0 ? text : text.substring(0, at);
        Plan plan = project.plan(id)
                .orElseThrow(() -> new IllegalArgumentException("the project has no plan '" + id + "'; it has "
                        + String.join(
                                ", ", project.plans().stream().map(Plan::id).toList())));
        return new PlannedMission(plan, plan.title(), Map.of(), at < 0 ? 0 : millis(text, text.substring(at + 1)));
    }

    private static long millis(String text, String seconds) {
        try {
            double value = Double.parseDouble(seconds);
            if (Double.isFinite(value)) {
                return Math.round(value * 1000);
            }
        } catch (NumberFormatException noNumber) {
            // reported together with those that are none
        }
        throw new IllegalArgumentException("'" + seconds + "' in '" + text + "' is no number of seconds");
    }
}
