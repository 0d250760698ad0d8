package org.sami.boat.server;

import org.sami.boat.link.CommandEpoch;
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

    /** Another session commands from now on, or the same one with a higher number: to be kept, and given back at the next start. */
    default void appointed(CommandEpoch epoch) {}

    /** Changes of commander that were not recorded, because there were too many. */
    default void leftOut(long nowMs, long count) {}
}
