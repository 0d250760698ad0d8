package org.sami.crw.operator.alarm;

import java.util.Objects;
import org.sami.spn.protocol.Priority;

/**
 * Something that is wrong with a boat and that the operator must know of.
 *
 * @param number of all alarms of the session, from 1; names it
 * @param boat id of the boat; empty text where it is not known, or where no single boat is concerned
 * @param other id of the second boat, where two are concerned; else empty text
 * @param text one sentence
 * @param sinceMillis when it began, on the session's clock
 * @param active whether it is still so; what is over stays until it is acknowledged
 * @param acknowledged whether the operator has said that it is known
 * @param muted whether alarms of this kind about this boat are to make no sound
 */
public record Alarm(
        long number,
        Kind kind,
        String boat,
        String other,
        String text,
        long sinceMillis,
        boolean active,
        boolean acknowledged,
        boolean muted) {

    /** What is wrong. */
    public enum Kind {
        /** Nothing comes from the boat. */
        LINK_LOST(Priority.HIGH),
        /** The boat puts its battery into the critical class. */
        BATTERY_CRITICAL(Priority.CRITICAL),
        /** The boat puts its battery into the low class. */
        BATTERY_LOW(Priority.MEDIUM),
        /** The charge does not last for what is left of the boat's path. */
        RANGE(Priority.HIGH),
        /** The boat does nothing before a person helps: its server started anew, it refuses this base, or its battery is empty. */
        BOAT_CRITICAL(Priority.CRITICAL),
        /** The boat is, or went, outside of the fence or inside an area that it must not enter; or the fence cannot be watched. */
        FENCE(Priority.CRITICAL),
        /** A mission sends the boat there. */
        FENCE_AHEAD(Priority.HIGH),
        /** Two boats are about to meet. */
        APPROACH(Priority.HIGH),
        /** The boat should follow its path, and comes no nearer to its next point. */
        NO_PROGRESS(Priority.HIGH),
        /** The link stands, and the boat has not said for a while where it is. */
        STALE_POSE(Priority.MEDIUM),
        /** The boat says that it is where it cannot be. */
        POSITION_DOUBTFUL(Priority.HIGH),
        /** The boat does not go where it says that it heads. */
        COMPASS_DOUBTFUL(Priority.HIGH),
        /** Two boats have one id, or one boat answers at two addresses. */
        DUPLICATE_ID(Priority.HIGH),
        /** Something else about a link, such as a boat that speaks another version of it. */
        LINK_FAULT(Priority.MEDIUM);

        private final Priority severity;

        Kind(Priority severity) {
            this.severity = severity;
        }

        /** How bad it is. */
        public Priority severity() {
            return severity;
        }
    }

    public Alarm {
        Objects.requireNonNull(kind, "kind");
        Objects.requireNonNull(boat, "boat");
        Objects.requireNonNull(other, "other");
        Objects.requireNonNull(text, "text");
    }

    /** Whether it is to be heard: it is active, not acknowledged and not muted. */
    public boolean sounds() {
        return active && !acknowledged && !muted;
    }
}
