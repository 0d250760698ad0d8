package org.sami.crw.operator;

import java.util.List;
import java.util.Objects;
import java.util.Optional;
import org.sami.spn.value.GeoPoint;

/**
 * An action or note of an operator.
 *
 * @param number among all entries of the session, from 1
 * @param atMillis its time on the session's clock
 * @param text one line
 * @param mission the mission concerned; {@code Ids.NONE} for none
 * @param boats the boats concerned; may be empty
 * @param position for a note about a place; empty for none
 */
public record OperatorLogEntry(
        long number,
        long atMillis,
        Kind kind,
        String text,
        long mission,
        List<String> boats,
        Optional<GeoPoint> position) {

    /** What sort of action it was. */
    public enum Kind {
        /** A mission was started, aborted or completed, or a boat dropped from it. */
        MISSION,
        /** A decision was answered, or the timer of one was stopped. */
        ANSWER,
        /** An interrupt was pressed. */
        INTERRUPT,
        /** A boat was connected, disconnected, taken, given away, driven, stopped or released. */
        BOAT,
        /** The fleet was stopped, or released. */
        FLEET_STOP,
        /** A task was moved. */
        TASK,
        /** A variable was set, or a project loaded. */
        PROJECT,
        /** The fence was set or taken away. */
        FENCE,
        /** A message or an alarm was acknowledged. */
        ACKNOWLEDGED,
        /** Messages or alarms were muted, or are heard again. */
        MUTED,
        /** A free note. */
        NOTE
    }

    public OperatorLogEntry {
        Objects.requireNonNull(kind, "kind");
        Objects.requireNonNull(text, "text");
        boats = List.copyOf(boats);
        Objects.requireNonNull(position, "position");
    }
}
