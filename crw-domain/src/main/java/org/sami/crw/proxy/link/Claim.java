package org.sami.crw.proxy.link;

import java.util.Optional;
import org.sami.boat.link.CommandEpoch;
import org.sami.boat.link.Role;
import org.sami.boat.link.Welcome;

/**
 * With which number this base claims the command of a boat. A base that has never commanded the boat claims the next number. One that has keeps the number
 * of its appointment, so that the boat refuses it once another base has taken over; only a take-over by its operator raises it.
 */
final class Claim {
    private long own; // of this base's last appointment; 0 if it never was appointed
    private CommandEpoch newest = CommandEpoch.NONE;
    private boolean numbered = true;

    /** The boat has said who has the command. */
    void welcomed(Welcome welcome) {
        numbered = welcome.epoch().isPresent();
        newest = welcome.epoch().orElse(CommandEpoch.NONE);
        if (welcome.role() == Role.COMMANDER) {
            own = newest.number();
        }
    }

    /** Number of a claim that a base makes by itself. */
    long number() {
        return own > 0 ? own : takeOver();
    }

    /** Number of a take-over: above all that the boat has named. */
    long takeOver() {
        return newest.number() + 1;
    }

    /** Whether this base has never commanded the boat, so that it may raise its claim by itself. */
    boolean isNew() {
        return own == 0;
    }

    /** Who has taken the boat over from this base; empty if nobody has. */
    Optional<CommandEpoch> supersededBy() {
        return Optional.of(newest).filter(epoch -> own > 0 && epoch.number() > own);
    }

    /** Who was appointed last, as the boat names them; empty where it does not. */
    Optional<String> holder() {
        return Optional.of(newest.clientId()).filter(name -> !name.isEmpty());
    }

    /** Who was appointed last that is no base: a pilot, another ground station or a failsafe of an autopilot, as the boat names them. */
    Optional<String> controller() {
        return holder().filter(name -> newest.session().equals(CommandEpoch.NO_BASE));
    }

    /** Whether the boat numbers its commanders; boats of the link of before do not. */
    boolean isNumbered() {
        return numbered;
    }
}
