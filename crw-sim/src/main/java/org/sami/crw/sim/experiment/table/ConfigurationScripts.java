package org.sami.crw.sim.experiment.table;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import org.sami.crw.sim.run.incident.IncidentRunInput.ResolutionSpan;
import org.sami.crw.sim.run.incident.IncidentScript;
import org.sami.crw.sim.run.incident.PlaceOnWater;

/**
 * The scripts of a configuration.
 *
 * @param versions script by name of the version
 * @param criteria what single events are optimised for, by name of the version
 * @param incidents what happens in all of them
 */
record ConfigurationScripts(
        Map<String, IncidentScript> versions,
        Map<String, List<EventCriterion>> criteria,
        Incidents incidents,
        ResolutionSpan resolution) {
    ConfigurationScripts {
        versions = Collections.unmodifiableMap(new LinkedHashMap<>(versions));
        criteria = Map.copyOf(criteria);
        Objects.requireNonNull(incidents, "incidents");
        Objects.requireNonNull(resolution, "resolution");
    }

    /**
     * Which incidents a configuration has.
     *
     * @param count how many at drawn times
     * @param ofOneBoat whether each of those concerns a drawn boat
     * @param inside how many boats are inside the area at once
     */
    record Incidents(Kind kind, int count, boolean ofOneBoat, int inside, PlaceOnWater area) {
        /** How they come. */
        enum Kind {
            NONE,
            TIMES,
            BATTERY,
            INSIDE
        }
    }
}
