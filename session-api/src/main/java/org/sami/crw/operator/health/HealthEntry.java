package org.sami.crw.operator.health;

import java.util.Objects;
import org.sami.spn.protocol.Priority;

/**
 * A present fault.
 *
 * @param number among all faults of the session, from 1; names it while it lasts
 * @param fault the fault, in its newest words
 * @param sinceMillis its beginning on the session's clock
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
