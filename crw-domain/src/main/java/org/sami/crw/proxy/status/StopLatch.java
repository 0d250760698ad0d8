package org.sami.crw.proxy.status;

import java.util.Objects;

/**
 * Whether a boat's motors are stopped until somebody releases them, and who had that done.
 *
 * @param by the client that had it done, as the boat says; empty where that is this base, or the boat does not say it; of one that is overridden, who armed it
 */
public record StopLatch(Where where, String by) {
    /** They are not. */
    public static final StopLatch NONE = new StopLatch(Where.NOWHERE, "");

    /** This base did. */
    public static final StopLatch HERE = new StopLatch(Where.HERE, "");

    /** Who had it done. */
    public enum Where {
        /** Nobody. */
        NOWHERE,
        /** This base. */
        HERE,
        /** Another base, or this one before its restart. */
        ELSEWHERE,
        /** Somebody; but somebody else has armed the vehicle since, so that it may move. */
        OVERRIDDEN
    }

    public StopLatch {
        Objects.requireNonNull(where, "where");
        Objects.requireNonNull(by, "by");
    }

    /** It is latched, and somebody armed the vehicle all the same, who is named. */
    public static StopLatch overridden(String who) {
        return new StopLatch(Where.OVERRIDDEN, who);
    }

    /**
     * Another base did, or this one before its restart.
     *
     * @param client as the boat names it; empty where it does not
     */
    public static StopLatch elsewhere(String client) {
        return new StopLatch(Where.ELSEWHERE, client);
    }
}
