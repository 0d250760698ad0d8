package org.sami.crw.operator.boat;

import java.util.Objects;
import org.sami.crw.proxy.explanation.BoatExplanation;
import org.sami.crw.proxy.tcp.BoatAddress;

/**
 * An address without a boat for this base, though it keeps trying: no answer, or a refusal.
 *
 * @param address as {@code HOST:PORT}
 * @param boat id of the boat that was there in an earlier process; empty text where unknown
 * @param reason result of the last attempt, in words
 * @param refused whether a peer answered and was refused, or turned this base away
 * @param tries number of failed attempts
 * @param sinceMillis time of the first attempt on the session's clock
 */
public record UnreachedBoat(String address, String boat, String reason, boolean refused, long tries, long sinceMillis) {
    private static final String REFUSED = "refused";

    public UnreachedBoat {
        Objects.requireNonNull(address, "address");
        Objects.requireNonNull(boat, "boat");
        Objects.requireNonNull(reason, "reason");
    }

    /** What people call it: the boat where that is known, else the address. */
    public String name() {
        return boat.isEmpty() ? address : boat;
    }

    /** How it stands, to be read next to its name, such as {@code no answer · connection refused · tried 12 times in 2 min}. */
    public String state(long nowMillis) {
        return (refused ? REFUSED : "no answer") + (reason.isEmpty() ? "" : " · " + why()) + " · tried " + times()
                + " in " + Age.words(nowMillis - sinceMillis);
    }

    /** The same as a sentence, such as {@code 10.0.0.9:11411 does not answer (connection refused, tried 12 times)}. */
    public String sentence() {
        String who = boat.isEmpty() ? address : boat + " at " + address;
        if (refused) {
            return who + " is refused: " + why() + " (tried " + times() + ")";
        }
        return who + " does not answer (" + (reason.isEmpty() ? "" : reason + ", ") + "tried " + times() + ")";
    }

    /** What the operator can do about it, one sentence without a full stop. */
    public String advice() {
        if (refused && BoatAddress.isOnMavlink(address)) {
            return "Change what the reason names, or give the address up";
        }
        return refused
                ? "Look who is at this address: give that boat an id of its own, or give the address up"
                : "Switch the boat on, look at address and network; give the address up if no boat is there";
    }

    /** The reason, which need not say once more that it is one of a refusal. */
    private String why() {
        return reason.startsWith(REFUSED + ": ") ? reason.substring(REFUSED.length() + 2) : reason;
    }

    /** The same as a row among boats: a boat of which nothing is known. */
    BoatSnapshot row(long nowMillis) {
        return BoatSnapshot.unknown(
                name(),
                new BoatExplanation(false, BoatExplanation.Cause.NEVER_ANSWERED, name() + " " + state(nowMillis)));
    }

    private String times() {
        return tries == 1 ? "once" : tries + " times";
    }
}
