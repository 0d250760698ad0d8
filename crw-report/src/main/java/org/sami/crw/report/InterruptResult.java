package org.sami.crw.report;

import java.util.Objects;
import java.util.OptionalLong;

/**
 * One interrupt that was to be pressed.
 *
 * @param boat the boat concerned; empty text for all, names with spaces between them where several were chosen
 * @param trigger why it was pressed: {@link #TIME} or {@link #BATTERY}
 * @param pressedAtMillis simulated time of the first press; empty where the run was over before its time came
 * @param takenAtMillis simulated time at which a transition fired with it; empty where none ever did
 * @param presses how often it was pressed until it was taken or the run was over
 */
public record InterruptResult(
        String name,
        String boat,
        String trigger,
        OptionalLong pressedAtMillis,
        OptionalLong takenAtMillis,
        int presses) {
    /** Its time had come. */
    public static final String TIME = "time";

    /** The boat's battery had turned critical. */
    public static final String BATTERY = "battery";

    public InterruptResult {
        Objects.requireNonNull(name, "name");
        Objects.requireNonNull(boat, "boat");
        Objects.requireNonNull(trigger, "trigger");
        Objects.requireNonNull(pressedAtMillis, "pressedAtMillis");
        Objects.requireNonNull(takenAtMillis, "takenAtMillis");
    }

    /** Whether a transition took it. */
    public boolean taken() {
        return takenAtMillis.isPresent();
    }
}
