package org.sami.boat.link;

/**
 * Who commanded a boat last, and the number of that appointment. The number only grows with each appointment of another session, so that a boat refuses
 * a session which has been replaced. Immutable.
 */
public final class CommandEpoch {
    /** Nobody has ever commanded the boat with a number. */
    public static final CommandEpoch NONE = new CommandEpoch(0, "", "");

    /** Session of an appointment of somebody who is no base: a pilot, another ground station or the own failsafe of a vehicle of another maker. */
    public static final String NO_BASE = "no-base";

    /** A claim may be so much above a boat's number: one at the end of the range would keep out everybody else for good. */
    public static final long MOST_AHEAD = 1_000_000_000L;

    private final long number;
    private final String session;
    private final String clientId;

    /**
     * Makes an epoch of checked values; a value out of its range is an {@link IllegalArgumentException}.
     *
     * @param session id of the base's session; empty for a client of the link of before, which names none
     * @param clientId the client's name in its hello, for people
     */
    public CommandEpoch(long number, String session, String clientId) {
        this.number = Checks.atLeastZero("epoch", number);
        this.session = Checks.optionalName("session", session);
        this.clientId = Checks.optionalName("client", clientId);
    }

    /** The number; 0 for {@link #NONE}. */
    public long number() {
        return number;
    }

    /** Id of the session that was appointed. */
    public String session() {
        return session;
    }

    /** Name of the client that was appointed, for people. */
    public String clientId() {
        return clientId;
    }

    /** The next appointment, without a number of the client's own. */
    public CommandEpoch next(String nextSession, String nextClientId) {
        return new CommandEpoch(number + 1, nextSession, nextClientId);
    }

    /** Whether a claim to command is newer than this appointment, or is this appointment. */
    public boolean admits(CommandEpoch claim) {
        boolean same = session.equals(claim.session)
                && (session.isEmpty() ? clientId.equals(claim.clientId) : number == claim.number);
        boolean newer = !claim.session.isEmpty() && claim.number > number && claim.number - number <= MOST_AHEAD;
        return (number == 0 && claim.session.isEmpty()) || (same && number > 0) || newer;
    }
}
