package org.sami.crw.proxy.explanation;

import java.util.Objects;

/**
 * Why a boat moves or does not, in words for the operator.
 *
 * @param shouldMove whether the boat is expected to be under way now
 * @param cause the same in one word, for lists and filters
 */
public record BoatExplanation(boolean shouldMove, Cause cause, String text) {

    /** What a boat waits for, or does. */
    public enum Cause {
        /** It follows a path. */
        UNDER_WAY,
        /** It should follow a path, and has come no nearer to its next point for a while. */
        NO_PROGRESS,
        /** Nothing comes from it. */
        LINK_LOST,
        /** It has never answered. */
        NEVER_ANSWERED,
        /** It will not have this base. */
        REFUSES,
        /** Another base commands it. */
        COMMANDED_ELSEWHERE,
        /** The whole fleet is stopped. */
        FLEET_STOPPED,
        /** A person drives it. */
        TAKEN_OVER,
        /** Its server has restarted, and the operator has not answered whether it may move. */
        STARTED_ANEW,
        /** The link is back, and the boat has not said yet what it holds. */
        COMPARING,
        /** It has not said where it is, and its way has to keep clear of something. */
        NO_POSITION,
        /** It is a robot of another kind than those that the session's plans command. */
        OTHER_KIND,
        /** Nothing is left to drive with. */
        BATTERY_EMPTY,
        /** Its path is on the way to it, or is being started. */
        UPLOADING,
        /** It stays at the point where a mission wants it. */
        KEEPS_STATION,
        /** It turns all round and takes pictures. */
        TAKES_PICTURES,
        /** A stop was requested. */
        STOPPING,
        /** A mission keeps it where it is. */
        BLOCKED,
        /** All its commands are done. */
        ARRIVED,
        /** Its last command failed. */
        FAILED,
        /** Its last command was cancelled. */
        WITHDRAWN,
        /** It never had a command. */
        NO_COMMAND
    }

    /** Refuses null. */
    public BoatExplanation {
        Objects.requireNonNull(cause, "cause");
        Objects.requireNonNull(text, "text");
    }
}
