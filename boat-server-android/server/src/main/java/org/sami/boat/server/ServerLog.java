package org.sami.boat.server;

import org.sami.boat.link.CommandMessage;
import org.sami.boat.link.LinkMessage;

/** Gets to know what the boat server executes; called on the thread that drives the server, before the answer leaves. */
public interface ServerLog {
    /** Keeps nothing. */
    ServerLog NONE = (nowMs, clientId, command, answer) -> {};

    /**
     * A command was executed or refused; those that are only answered again do not come here.
     *
     * @param clientId who sent it
     */
    void answered(long nowMs, String clientId, CommandMessage command, LinkMessage answer);

    /** So many changes of who commands were not told, as there were too many. */
    default void leftOut(long nowMs, long count) {}
}
