package org.sami.boat.server;

import org.sami.boat.link.CommandMessage;
import org.sami.boat.link.LinkMessage;

/** Records what the boat server executes; called on the thread that drives the server, before the answer leaves. */
public interface ServerLog {
    /** Keeps nothing. */
    ServerLog NONE = (nowMs, clientId, command, answer) -> {};

    /**
     * A command was executed or refused. Repeated commands, which only get their answer again, are not recorded.
     *
     * @param clientId who sent it
     */
    void answered(long nowMs, String clientId, CommandMessage command, LinkMessage answer);

    /** Changes of commander that were not recorded, because there were too many. */
    default void leftOut(long nowMs, long count) {}
}
