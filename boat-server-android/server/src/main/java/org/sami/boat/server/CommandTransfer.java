package org.sami.boat.server;

import java.util.List;
import java.util.Optional;
import org.sami.boat.link.Ack;
import org.sami.boat.link.AskForCommand;
import org.sami.boat.link.CommandMessage;
import org.sami.boat.link.GrantCommand;
import org.sami.boat.link.LinkMessage;
import org.sami.boat.link.NackReason;
import org.sami.boat.link.Role;
import org.sami.boat.link.TakeCommand;

/** The consequences of a client's request to take, ask for or grant the command: whom to appoint, whom to ask, what to answer. */
final class CommandTransfer {
    private final LinkMessage answer;
    private final Optional<ServerSession> appointed;
    private final Optional<ServerSession> asked;

    private CommandTransfer(LinkMessage answer, Optional<ServerSession> appointed, Optional<ServerSession> asked) {
        this.answer = answer;
        this.appointed = appointed;
        this.asked = asked;
    }

    static boolean isOne(CommandMessage command) {
        return command instanceof AskForCommand || command instanceof GrantCommand || command instanceof TakeCommand;
    }

    static CommandTransfer of(
            CommandMessage command, ServerSession from, Optional<ServerSession> commander, List<ServerSession> all) {
        Optional<ServerSession> self = Optional.of(from);
        LinkMessage ack = new Ack(command.commandId());
        if (command instanceof GrantCommand) {
            return grant((GrantCommand) command, from, commander, all);
        } else if (command instanceof TakeCommand || !commander.isPresent()) {
            return new CommandTransfer(ack, self, Optional.empty());
        }
        boolean hasIt = commander.get() == from;
        return new CommandTransfer(ack, Optional.empty(), hasIt ? Optional.empty() : commander);
    }

    private static CommandTransfer grant(
            GrantCommand grant, ServerSession from, Optional<ServerSession> commander, List<ServerSession> all) {
        if (!commander.isPresent() || commander.get() != from) {
            return refused(grant, NackReason.NOT_COMMANDER, "this client does not command");
        }
        Optional<ServerSession> next = all.stream()
                .filter(session -> session != from && session.clientId().equals(grant.clientId()))
                .filter(session -> session.granted().equals(Optional.of(Role.COMMANDER)))
                .reduce((earlier, later) -> later); // a client that came back has an old and a new session
        return next.isPresent()
                ? new CommandTransfer(new Ack(grant.commandId()), next, Optional.empty())
                : refused(grant, NackReason.UNKNOWN_CLIENT, "no client " + grant.clientId() + " is linked");
    }

    private static CommandTransfer refused(CommandMessage command, NackReason reason, String detail) {
        return new CommandTransfer(CommandExecutor.nack(command, reason, detail), Optional.empty(), Optional.empty());
    }

    /** The answer to the sender. */
    LinkMessage answer() {
        return answer;
    }

    /** The new commander; empty if nothing changes. */
    Optional<ServerSession> appointed() {
        return appointed;
    }

    /** The commander to whom the wish is passed on; empty if there is none. */
    Optional<ServerSession> asked() {
        return asked;
    }
}
