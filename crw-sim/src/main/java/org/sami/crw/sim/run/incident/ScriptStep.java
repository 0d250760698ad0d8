package org.sami.crw.sim.run.incident;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Objects;

/** One step of an operator's script. A step begins when the one before it is done. */
public sealed interface ScriptStep {
    /**
     * Starts a root mission; done when it has started.
     *
     * @param plan its id
     * @param values for what the plan would ask, by name, as {@code crw run --set} takes them
     * @param boats which boats the operator chooses where the plan asks
     * @param ifUnvisited skip the step if every location has been visited
     */
    record Start(String plan, Map<String, String> values, BoatChoice boats, boolean ifUnvisited) implements ScriptStep {
        public Start {
            Objects.requireNonNull(plan, "plan");
            Objects.requireNonNull(boats, "boats");
            values = Collections.unmodifiableMap(new LinkedHashMap<>(values));
        }
    }

    /** Aborts the running root missions of a plan; done when they have ended. */
    record Abort(String plan) implements ScriptStep {
        public Abort {
            Objects.requireNonNull(plan, "plan");
        }
    }

    /**
     * Presses an interrupt, once a second until a transition takes it or no mission runs.
     *
     * @param namesBoats whether the incident's boats are named with it
     */
    record Press(String interrupt, boolean namesBoats) implements ScriptStep {
        public Press {
            Objects.requireNonNull(interrupt, "interrupt");
        }
    }

    /** Waits until no mission of a plan runs, neither as root nor as sub-mission. */
    record Await(String plan) implements ScriptStep {
        public Await {
            Objects.requireNonNull(plan, "plan");
        }
    }

    /** Lets simulated time pass. */
    record Pause(long millis) implements ScriptStep {}

    /** The boats that an operator chooses. */
    enum BoatChoice {
        /** All that are offered. */
        ALL,
        /** Those of the incident. */
        INCIDENT,
        /** All but those of the incident. */
        OTHERS,
        /** Those of the incident but the last, one after another: each in a mission of its own, which ends before the next one starts. */
        EACH_BUT_ONE,
        /** The one whose turn it is of those. */
        NEXT
    }
}
