package org.sami.crw.handler.motion;

import java.util.Objects;
import java.util.Optional;
import org.sami.crw.handler.activation.EventNames;

/**
 * The input events that report the result of a command to a plan; an empty name for no report.
 *
 * @param completed when it is done
 * @param failed when it cannot be done; has the field {@code reason}
 * @param pictures when pictures were taken; has the fields {@code location} and {@code pictures}
 * @param ifAwaited whether the events are sent only where a transition waits for them
 */
public record Reply(String completed, String failed, String pictures, boolean ifAwaited) {
    /** Of a way somewhere. */
    static final Reply WAY = way(EventNames.PATH_COMPLETED, EventNames.PATH_FAILED);

    /** Of a way somewhere that need not be waited for. */
    static final Reply WAY_IF_AWAITED = new Reply(EventNames.PATH_COMPLETED, EventNames.PATH_FAILED, "", true);

    /** Of a stop, which need not be waited for. */
    static final Reply STOP_IF_AWAITED = new Reply(EventNames.BLOCK_DONE, "", "", true);

    /** Of a station, which is kept without an end, and need not be waited for. */
    static final Reply STATION_IF_AWAITED = new Reply("", EventNames.PATH_FAILED, "", true);

    /** Panorama events. Completion has its own event; a failure is reported to the place that waits for it. */
    static final Reply PICTURES_IF_AWAITED = new Reply("", EventNames.PANORAMA_FAILED, EventNames.PANORAMA_TAKEN, true);

    /** No events: the mission has ended, or receives more than the end of the command. */
    public static final Reply NONE = new Reply("", "", "", true);

    public Reply {
        Objects.requireNonNull(completed, "completed");
        Objects.requireNonNull(failed, "failed");
        Objects.requireNonNull(pictures, "pictures");
    }

    /** Of a way somewhere, always reported. */
    public static Reply way(String completed, String failed) {
        return new Reply(completed, failed, "", false);
    }

    Optional<String> completedEvent() {
        return Optional.of(completed).filter(name -> !name.isEmpty());
    }

    Optional<String> failedEvent() {
        return Optional.of(failed).filter(name -> !name.isEmpty());
    }
}
