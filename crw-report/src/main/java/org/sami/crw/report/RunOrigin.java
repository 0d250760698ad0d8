package org.sami.crw.report;

import java.time.Instant;
import java.time.ZoneId;
import java.time.temporal.ChronoUnit;
import java.util.Objects;

/**
 * When a run began, and which program reports it. Nothing that happens in a run depends on it: equal runs that began at other times
 * have equal hashes.
 *
 * @param startedAt when the process began that began the run, to the millisecond
 * @param zone the time zone of that machine
 * @param version of the program that writes the report
 */
public record RunOrigin(Instant startedAt, ZoneId zone, String version) {
    /** The origin of a run; what is finer than a millisecond is cut off. */
    public RunOrigin {
        startedAt = startedAt.truncatedTo(ChronoUnit.MILLIS);
        Objects.requireNonNull(zone, "zone");
        Objects.requireNonNull(version, "version");
    }

    /** The moment at a time of the run: simulated time goes on from the start. */
    public Instant at(long atMillis) {
        return startedAt.plusMillis(atMillis);
    }
}
