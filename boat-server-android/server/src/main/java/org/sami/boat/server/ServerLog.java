package org.sami.boat.server;

import org.sami.boat.link.CommandMessage;
import org.sami.boat.link.LinkMessage;

/** Gets to know what the boat server executes; called on the thread that drives the server, before the answer leaves. */
public interface ServerLog {
    /** Keeps nothing. */
    ServerLog NONE = (nowMs, command, answer) -> {};

    /** A command with a new id was executed or refused; repeated ids do not come here. */
    void answered(long nowMs, CommandMessage command, LinkMessage answer);
}
