package org.sami.boat.server.log;

import java.util.Objects;
import org.sami.boat.link.CommandMessage;
import org.sami.boat.link.LinkMessage;

/** One entry of a boat's log: a command that the boat executed or refused, its client and its answer. */
public final class LoggedCommand {
    private final String bootId;
    private final long timeMs;
    private final String clientId;
    private final CommandMessage command;
    private final LinkMessage answer;

    /** Makes an entry. */
    public LoggedCommand(String bootId, long timeMs, String clientId, CommandMessage command, LinkMessage answer) {
        this.bootId = Objects.requireNonNull(bootId, "bootId");
        this.timeMs = timeMs;
        this.clientId = Objects.requireNonNull(clientId, "clientId");
        this.command = Objects.requireNonNull(command, "command");
        this.answer = Objects.requireNonNull(answer, "answer");
    }

    /** The start of the server that it happened in. */
    public String bootId() {
        return bootId;
    }

    /** The boat's clock in ms, which begins at zero with each start. */
    public long timeMs() {
        return timeMs;
    }

    /** Who sent the command; empty in entries of earlier versions, which do not say so. */
    public String clientId() {
        return clientId;
    }

    /** The command. */
    public CommandMessage command() {
        return command;
    }

    /** What it answered: an acknowledgement or a refusal. */
    public LinkMessage answer() {
        return answer;
    }
}
