package org.sami.crw.operator.health;

import java.util.Objects;
import org.sami.spn.protocol.Priority;

/**
 * A fault that is not over.
 *
 * @param number of all faults of the session, from 1; names it as long as it lasts
 * @param fault what is wrong, in the newest words
 * @param sinceMillis when it began, on the session's clock
 */
public record HealthEntry(long number, HealthFault fault, long sinceMillis) {
    public HealthEntry {
        Objects.requireNonNull(fault, "fault");
    }

    /** How bad it is. */
    public Priority severity() {
        return fault.severity();
    }
}
