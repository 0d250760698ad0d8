package org.sami.crw.sim.report;

import java.util.Objects;

/**
 * One interrupt that was pressed.
 *
 * @param boat whom it was about; empty text for all
 * @param pressedAtMillis simulated time
 * @param taken whether a transition took it; otherwise it was refused
 */
public record InterruptResult(String name, String boat, long pressedAtMillis, boolean taken) {
    public InterruptResult {
        Objects.requireNonNull(name, "name");
        Objects.requireNonNull(boat, "boat");
    }
}
