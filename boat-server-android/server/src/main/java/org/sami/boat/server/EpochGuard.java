package org.sami.boat.server;

import java.util.Optional;
import org.sami.boat.link.AskForCommand;
import org.sami.boat.link.CommandEpoch;
import org.sami.boat.link.CommandMessage;
import org.sami.boat.link.Nack;
import org.sami.boat.link.NackReason;
import org.sami.boat.link.TakeCommand;

/**
 * Keeps the newest appointment of a commander, and refuses sessions which have been replaced since. A client of the link of before names no session: it
 * commands as long as no session has, or when it takes the command; it then gets the next number. For the thread that drives the boat.
 */
final class EpochGuard {
    private final ServerLog log;
    private CommandEpoch newest = CommandEpoch.NONE;

    EpochGuard(ServerLog log) {
        this.log = log;
    }

    /** The newest appointment. */
    CommandEpoch newest() {
        return newest;
    }

    /** The newest appointment of earlier starts of this boat. */
    void restore(CommandEpoch kept) {
        newest = kept.number() > newest.number() ? kept : newest;
    }

    /** Why a client may not be appointed with what it claims; empty if it may. */
    Optional<String> refusal(CommandEpoch claim) {
        if (newest.admits(claim)) {
            return Optional.empty();
        }
        String held =
                newest.number() == 0 ? "" : ": " + newest.clientId() + " has the command, number " + newest.number();
        if (claim.session().isEmpty()) {
            return Optional.of("this base speaks the link of before, without numbers of take-overs" + held
                    + "; take the command, or bring the base to the boat's version");
        }
        return Optional.of("this base was replaced, its number is " + claim.number() + held
                + "; take the command to have it again");
    }

    /**
     * Why a client is not appointed by its own request; empty if it is, if nobody is appointed by it, or if it commands already.
     *
     * @param commands whether it is the commander
     * @param present whether a commander is linked
     */
    Optional<Nack> refusal(CommandMessage request, String clientId, boolean commands, boolean present) {
        boolean take = request instanceof TakeCommand;
        boolean appoints = take || (request instanceof AskForCommand && !present);
        if (commands || !appoints) {
            return Optional.empty();
        }
        CommandEpoch claim = claim(request, clientId);
        boolean before = claim.session().isEmpty();
        if (before && take) { // a person does that, with a base that cannot know the number
            return Optional.empty();
        }
        NackReason reason =
                before ? NackReason.NOT_COMMANDER : NackReason.SUPERSEDED; // that base does not know the other
        return refusal(claim).map(why -> new Nack(request.commandId(), reason, why));
    }

    private static CommandEpoch claim(CommandMessage request, String clientId) {
        if (request instanceof TakeCommand) {
            TakeCommand take = (TakeCommand) request;
            return new CommandEpoch(take.epoch(), take.session(), clientId);
        } else if (request instanceof AskForCommand) {
            AskForCommand ask = (AskForCommand) request;
            return new CommandEpoch(ask.epoch(), ask.session(), clientId);
        }
        return CommandEpoch.NONE; // a grant, whose number is the boat's
    }

    /** A client was appointed by its hello. */
    void appoint(CommandEpoch claim) {
        if (claim.number() > newest.number()) {
            keep(claim);
        }
    }

    /** A client was appointed by a request: with the number in it, or with the next one where it has none. */
    void appoint(CommandMessage request, String session, String clientId) {
        CommandEpoch claim = claim(request, clientId);
        boolean counts = newest.number() > 0 || !session.isEmpty(); // numbers begin with the first session
        if (!claim.session().isEmpty()) {
            appoint(claim);
        } else if (counts) {
            keep(newest.next(session, clientId));
        }
    }

    private void keep(CommandEpoch next) {
        newest = next;
        log.appointed(next);
    }
}
