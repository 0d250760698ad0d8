package org.sami.crw.operator.alarm;

import java.util.Objects;
import org.sami.spn.protocol.Priority;

/**
 * An alarm about a boat.
 *
 * @param number among all alarms of the session, from 1; names it
 * @param boat id of the boat; empty text where unknown, or where it concerns no single boat
 * @param other id of the second boat, where two are concerned; otherwise empty text
 * @param text one sentence
 * @param sinceMillis its beginning on the session's clock
 * @param active whether its cause lasts; an alarm that is over stays until it is acknowledged
 * @param acknowledged whether the operator has acknowledged it
 * @param muted whether alarms of this kind about this boat are silent
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
        LINK_LOST(Priority.HIGH, "Wait or bring it into reach: the boat does what it is set to do without a link"),
        /** The boat puts its battery into the critical class. */
        BATTERY_CRITICAL(Priority.CRITICAL, "Send it home now, or fetch it"),
        /** The boat puts its battery into the low class. */
        BATTERY_LOW(Priority.MEDIUM, "Send it home soon, or have its battery swapped"),
        /** The charge does not last for what is left of the boat's path. */
        RANGE(Priority.HIGH, "Shorten its path, or send it home"),
        /** The boat does nothing before a person helps: its server restarted, it refuses this base, or its battery is empty. */
        BOAT_CRITICAL(Priority.CRITICAL, "Look at the boat: it does nothing before a person helps"),
        /** The boat is, or went, outside of the fence or inside an area that it must not enter; or the fence cannot be watched. */
        FENCE(Priority.CRITICAL, "Stop the boat, or send it back into its water"),
        /** A mission sends the boat there. */
        FENCE_AHEAD(Priority.HIGH, "Give it another path, or hold it"),
        /** Two boats are about to meet. */
        APPROACH(Priority.HIGH, "Hold one of the two"),
        /** The boat should follow its path, and comes no nearer to its next point. */
        NO_PROGRESS(Priority.HIGH, "Look whether it is stuck; send its path again, or take it over by hand"),
        /** The boat was carried away from where it was left, or from the station that it is to keep. */
        DRIFT(Priority.HIGH, "Have it hold its place, send it home, or fetch it"),
        /** The link stands, and the boat has not said for a while where it is. */
        STALE_POSE(Priority.MEDIUM, "Look at its GPS, or at its phone's; hold the boat meanwhile"),
        /** The boat says that it is where it cannot be. */
        POSITION_DOUBTFUL(Priority.HIGH, "Hold the boat until its position is sound"),
        /** The boat does not go where it says that it heads. */
        COMPASS_DOUBTFUL(Priority.HIGH, "Hold the boat; look at its compass and its motor"),
        /** The boat's phone is so hot that it slows down, and may switch itself off. */
        PHONE_HOT(Priority.HIGH, "Shade the boat or fetch it: a phone that gets hotter switches itself off"),
        /** The boat's phone has little room left for logs and pictures. */
        PHONE_STORAGE(Priority.MEDIUM, "Fetch its logs, then delete something on the phone"),
        /** The boat's log cannot be written. */
        PHONE_LOG(Priority.HIGH, "Fetch the boat before its phone restarts; look at the phone's storage"),
        /** The boat's phone has lost its date, or its date was set. Nothing that the boat does follows its date. */
        PHONE_DATE(Priority.MEDIUM, "Set the phone's date; compare the times of its logs with care"),
        /** Two boats have one id, or one boat answers at two addresses. */
        DUPLICATE_ID(Priority.HIGH, "Give one of the boats another id, or disconnect one address"),
        /** A boat sends more than the base takes in; the text says how much was left out. */
        LINK_FLOOD(
                Priority.HIGH,
                "Look at the boat's server and its sensors, or disconnect it; commands still come through"),
        /** Something else about a link, such as a boat that speaks another version of it. */
        LINK_FAULT(Priority.MEDIUM, "Look at the address and at the version of the boat's server");

        private final Priority severity;
        private final String advice;

        Kind(Priority severity, String advice) {
            this.severity = severity;
            this.advice = advice;
        }

        /** How bad it is. */
        public Priority severity() {
            return severity;
        }

        /** What the operator can do about it: one sentence without a full stop at its end. */
        public String advice() {
            return advice;
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
