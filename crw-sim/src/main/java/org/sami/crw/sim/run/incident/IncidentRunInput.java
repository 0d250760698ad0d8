package org.sami.crw.sim.run.incident;

import java.util.Objects;
import org.sami.crw.sim.run.settings.FleetSettings;
import org.sami.spn.model.Project;
import org.sami.spn.vocabulary.Vocabulary;

/**
 * All that a run with incidents is a function of.
 *
 * @param project with all plans that the script starts
 * @param answerAfterMillis delay of each answer
 * @param limitMillis simulated time after which the run is stopped
 * @param phase what the run measures in addition
 */
public record IncidentRunInput(
        Vocabulary vocabulary,
        Project project,
        FleetSettings fleet,
        long answerAfterMillis,
        long limitMillis,
        IncidentScript script,
        IncidentKind incidents,
        ResolutionSpan phase) {
    public IncidentRunInput {
        Objects.requireNonNull(vocabulary, "vocabulary");
        Objects.requireNonNull(project, "project");
        Objects.requireNonNull(fleet, "fleet");
        Objects.requireNonNull(script, "script");
        Objects.requireNonNull(incidents, "incidents");
        Objects.requireNonNull(phase, "phase");
    }

    /**
     * From when an interrupt is taken until the last of its boats has fired a transition; the mean over all presses.
     *
     * @param interrupt its name; empty text where no such time is measured
     * @param transition id of the transition
     */
    public record ResolutionSpan(String interrupt, String transition) {
        /** Measures nothing. */
        public static final ResolutionSpan NONE = new ResolutionSpan("", "");

        public ResolutionSpan {
            Objects.requireNonNull(interrupt, "interrupt");
            Objects.requireNonNull(transition, "transition");
        }
    }
}
