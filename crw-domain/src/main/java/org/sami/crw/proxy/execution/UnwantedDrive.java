package org.sami.crw.proxy.execution;

import org.sami.boat.link.Progress;
import org.sami.crw.proxy.link.ProxyConfig;

/**
 * Notices a boat that, once its link is back, drives along a list of this base for which the base has no command. Lists of other bases are theirs to stop.
 * A list of an earlier start of this base is given some time, as the command for it may come again from the journal.
 */
final class UnwantedDrive {
    private static final long EARLIER_START_MS = 10_000;
    /** Where the boat holds no such list. */
    private static final long NEVER = Long.MAX_VALUE;

    private final String ofBase;
    private final String ofThisStart;
    private long graceMs = NEVER;
    private long stopAtMs = NEVER;

    /** Nothing is known of the boat yet. */
    UnwantedDrive(ProxyConfig config) {
        ofBase = config.clientId() + ".";
        ofThisStart = ofBase + config.epoch() + ".";
    }

    /** The boat has said what it holds, after a time without a link. */
    void resumed(Progress held) {
        String maker = held.listId().substring(held.listId().lastIndexOf('#') + 1);
        stopAtMs = NEVER;
        if (held.completed() || !maker.startsWith(ofBase)) {
            graceMs = NEVER;
        } else {
            graceMs = maker.startsWith(ofThisStart) ? 0 : EARLIER_START_MS;
        }
    }

    /**
     * The boat has said what it does.
     *
     * @param drives whether it drives along its list
     * @param isWanted whether the base has a command for it
     * @return whether it is to be stopped
     */
    boolean isToStop(boolean drives, boolean isWanted, long nowMs) {
        if (!drives || isWanted) {
            graceMs = NEVER; // from now on the commands decide
        }
        if (graceMs == NEVER) {
            return false;
        }
        stopAtMs = Math.min(stopAtMs, nowMs + graceMs);
        boolean isDue = nowMs >= stopAtMs;
        if (isDue) {
            graceMs = NEVER; // the stop is repeated until the boat answers
        }
        return isDue;
    }
}
