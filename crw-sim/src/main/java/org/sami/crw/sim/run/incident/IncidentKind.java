package org.sami.crw.sim.run.incident;

import java.util.List;
import java.util.Objects;

/** Which incidents a run has. */
public sealed interface IncidentKind {
    /** No incident: the run is undisturbed. */
    record None() implements IncidentKind {}

    /** Incidents at times that were drawn before the run, in order. */
    record AtTimes(List<PlannedIncident> incidents) implements IncidentKind {
        public AtTimes {
            incidents = List.copyOf(incidents);
        }
    }

    /** One for each boat whose battery turns critical. */
    record CriticalBattery() implements IncidentKind {}

    /**
     * Several boats are inside an area at once, by the positions that they report. It happens again when another boat is inside with them.
     *
     * @param boats at least so many
     */
    record BoatsInside(int boats, PlaceOnWater area) implements IncidentKind {
        public BoatsInside {
            Objects.requireNonNull(area, "area");
        }
    }

    /**
     * An incident at a time.
     *
     * @param afterMillis since the start of the first mission
     * @param boats whom it concerns; empty for all
     */
    record PlannedIncident(long afterMillis, List<String> boats) {
        public PlannedIncident {
            boats = List.copyOf(boats);
        }
    }
}
