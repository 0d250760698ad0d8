package org.sami.crw.sim.run.incident;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;

/**
 * What the operator of a run does.
 *
 * @param start steps with which the run begins
 * @param onIncident steps for each incident; the next incident waits until they are done
 * @param places what is answered where a point or an area is asked for, by field or variable
 * @param delays of single answers
 * @param background what the operator does besides the missions, from the start to the end of the run
 */
public record IncidentScript(
        List<ScriptStep> start,
        List<ScriptStep> onIncident,
        Map<String, PlaceOnWater> places,
        List<AnswerDelay> delays,
        BackgroundActions background) {
    public IncidentScript {
        start = List.copyOf(start);
        onIncident = List.copyOf(onIncident);
        places = Collections.unmodifiableMap(new LinkedHashMap<>(places));
        delays = List.copyOf(delays);
        Objects.requireNonNull(background, "background");
    }

    /**
     * How long the answer to an event takes in addition to others.
     *
     * @param plan that asks
     * @param event its type
     */
    public record AnswerDelay(String plan, String event, long millis) {
        public AnswerDelay {
            Objects.requireNonNull(plan, "plan");
            Objects.requireNonNull(event, "event");
        }
    }
}
