package org.sami.crw.operator;

import java.util.Objects;
import org.sami.spn.protocol.Decision;

/**
 * A decision that waits for the operator.
 *
 * @param openedAtMillis when it was asked, on the session's clock
 */
public record PendingDecision(Decision decision, long openedAtMillis) {
    public PendingDecision {
        Objects.requireNonNull(decision, "decision");
    }
}
