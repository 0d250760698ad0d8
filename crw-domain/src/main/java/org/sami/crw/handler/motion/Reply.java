package org.sami.crw.handler.motion;

import java.util.Optional;
import org.sami.crw.handler.activation.EventNames;

/** The input events that report the result of a command to a plan; empty for no report. */
enum Reply {
    /** Of a way somewhere. */
    WAY(EventNames.PATH_COMPLETED, EventNames.PATH_FAILED),
    /** Of a way somewhere that need not be waited for. */
    WAY_IF_AWAITED(EventNames.PATH_COMPLETED, EventNames.PATH_FAILED),
    /** Of a stop, which need not be waited for. */
    STOP_IF_AWAITED(EventNames.BLOCK_DONE, ""),
    /** Of a station, which is kept without an end, and need not be waited for. */
    STATION_IF_AWAITED("", EventNames.PATH_FAILED),
    /** Panorama events. Completion has its own event; a failure is reported to the place that waits for it. */
    PICTURES_IF_AWAITED("", EventNames.PANORAMA_FAILED),
    /** No events: the mission has ended, or receives more than the end of the command. */
    NONE("", "");

    private final String completed;
    private final String failed;

    Reply(String completed, String failed) {
        this.completed = completed;
        this.failed = failed;
    }

    Optional<String> completed() {
        return Optional.of(completed).filter(name -> !name.isEmpty());
    }

    /** Whether it is only sent where a transition waits for it. */
    boolean ifAwaited() {
        return this != WAY;
    }

    Optional<String> failed() {
        return Optional.of(failed).filter(name -> !name.isEmpty());
    }
}
