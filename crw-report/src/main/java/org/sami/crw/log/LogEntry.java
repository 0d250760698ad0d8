package org.sami.crw.log;

import java.util.Map;
import java.util.Objects;
import org.sami.spn.value.GeoPoint;

/** What a line of a boat's log says. */
sealed interface LogEntry {
    /**
     * Where the boat took itself to be, out of position fixes and sensors.
     *
     * @param yawRad as logged: radians, the sense of turning is not documented
     */
    record Pose(GeoPoint at, double yawRad) implements LogEntry {
        public Pose {
            Objects.requireNonNull(at, "at");
        }
    }

    /** A raw position fix of the satellite receiver. */
    record Fix(GeoPoint at) implements LogEntry {
        public Fix {
            Objects.requireNonNull(at, "at");
        }
    }

    /**
     * What a sensor measured, in its own units.
     *
     * @param sensor as the log names it
     * @param values by channel, in the log's order; a channel without a name has its number, from 1
     */
    record Reading(String sensor, Map<String, Double> values) implements LogEntry {
        public Reading {
            Objects.requireNonNull(sensor, "sensor");
            Objects.requireNonNull(values, "values");
        }
    }

    /** A command to the boat or to its motors, as logged. */
    record Command(String text) implements LogEntry {
        public Command {
            Objects.requireNonNull(text, "text");
        }
    }
}
