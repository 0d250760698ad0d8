package org.sami.boat.server;

import java.util.Optional;
import org.sami.boat.link.BoatMode;

/** What a boat does at an event. */
enum ModeAction {
    /** Goes on with what it does. */
    KEEP,
    /** Goes on with what it does; a command is refused because the fleet stop is latched. */
    DENY,
    /** Sets the motors to zero. */
    STOP(BoatMode.STOPPED),
    /** Sets the motors to zero until the fleet is released. */
    LOCK(BoatMode.FLEET_STOP),
    /** Keeps station. */
    HOLD(BoatMode.HOLD),
    /** Follows the waypoint list. */
    PATH(BoatMode.PATH),
    /** Drives to the home position. */
    HOME(BoatMode.RETURN),
    /** Sets the motors as the commander says. */
    HAND(BoatMode.TELEOPERATION),
    /** The event does not occur in this mode. */
    NONE;

    private final Optional<BoatMode> next;

    ModeAction() {
        next = Optional.empty();
    }

    ModeAction(BoatMode next) {
        this.next = Optional.of(next);
    }

    /** The boat's mode afterwards. */
    BoatMode after(BoatMode before) {
        return next.orElse(before);
    }
}
