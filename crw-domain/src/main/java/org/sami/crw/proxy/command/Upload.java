package org.sami.crw.proxy.command;

import java.util.List;
import java.util.Objects;
import org.sami.spn.value.GeoPoint;

/**
 * Progress of a waypoint list on its way to the boat.
 *
 * @param listId names the list on the link; never used for another
 * @param commandId the command of the path
 * @param way its points in driving order: those of the path, and turns around no-go areas
 * @param why reason of a failure in words; empty in the other states
 */
public record Upload(String listId, String commandId, List<GeoPoint> way, State state, String why) {

    /** How far it has come; one after the other, and failed after either of the first two. */
    public enum State {
        /** It has been sent; what the boat holds is not known. */
        SENT,
        /** The boat has said that it took it whole. */
        ACKNOWLEDGED,
        /** The boat has said what it holds, and that is equal to the last bit. */
        READ_BACK_EQUAL,
        /** It was not sent: the boat holds it since an earlier process of this base sent it, read back equal. */
        TAKEN_OVER,
        /** It is given up; what the boat holds is not known, and is not started from here. */
        FAILED;

        /** Whether nothing more comes of it. */
        public boolean isFinal() {
            return this != SENT && this != ACKNOWLEDGED;
        }
    }

    /** Refuses a reason without a failure, and a failure without a reason. */
    public Upload {
        Objects.requireNonNull(listId, "listId");
        Objects.requireNonNull(commandId, "commandId");
        way = List.copyOf(way);
        if (why.isEmpty() == (state == State.FAILED)) {
            throw new IllegalArgumentException("an upload that is " + state + " because of: " + why);
        }
    }

    /** One that has gone so far and has not failed. */
    public static Upload of(String listId, String commandId, List<GeoPoint> way, State state) {
        return new Upload(listId, commandId, way, state, "");
    }

    /** The same, given up for a reason in words. */
    public Upload failed(String reason) {
        return new Upload(listId, commandId, way, State.FAILED, reason);
    }
}
