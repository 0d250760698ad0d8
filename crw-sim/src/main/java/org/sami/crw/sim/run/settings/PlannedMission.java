package org.sami.crw.sim.run.settings;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.value.Value;
import org.sami.spn.vocabulary.Vocabulary;

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
     * Reads {@code PLAN[@SECONDS]}: a mission of another plan of the project, or of the same once more. Each further line is {@code NAME=VALUE},
     * a value for what the plan would ask at its start; it asks for the rest.
     *
     * @throws IllegalArgumentException if the project has no such plan, a value does not fit it, or the time makes no sense
     */
    public static PlannedMission parse(String text, Vocabulary vocabulary, Project project) {
        List<String> lines = text.lines().toList();
        String first = lines.isEmpty() ? "" : lines.get(0);
        int at = first.lastIndexOf(AT);
        Plan plan = plan(at < 0 ? first : first.substring(0, at), project);
        Map<String, String> values = new LinkedHashMap<>();
        for (String line : lines.subList(Math.min(1, lines.size()), lines.size())) {
            int equals = line.indexOf('=');
            if (equals < 1) {
                throw new IllegalArgumentException("'" + line + "' is no NAME=VALUE");
            }
            values.put(line.substring(0, equals), line.substring(equals + 1));
        }
        return new PlannedMission(
                plan,
                plan.title(),
                new Parameters(vocabulary, project, plan).read(values),
                at < 0 ? 0 : millis(first, first.substring(at + 1)));
    }

    /**
     * Writes what {@link #parse} reads.
     *
     * @param parameters values by name; a value has no line break
     */
    public static String text(String plan, long afterMillis, Map<String, String> parameters) {
        StringBuilder text = new StringBuilder(plan + AT + afterMillis / 1000.0);
        parameters.forEach(
                (name, value) -> text.append('\n').append(name).append('=').append(value));
        return text.toString();
    }

    /**
     * A plan of a project.
     *
     * @throws IllegalArgumentException if there is none with that id
     */
    public static Plan plan(String id, Project project) {
        return project.plan(id)
                .orElseThrow(() -> new IllegalArgumentException("the project has no plan '" + id + "'; it has "
                        + String.join(
                                ", ", project.plans().stream().map(Plan::id).toList())));
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
