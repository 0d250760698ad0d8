package org.sami.boat.mavlink;

import java.util.Optional;
import org.sami.boat.link.BoatMode;
import org.sami.boat.link.FleetRelease;
import org.sami.boat.link.FleetStop;
import org.sami.boat.link.SettingsReport;
import org.sami.boat.link.StopMotors;
import org.sami.mavlink.vehicle.VehicleId;

/**
 * The stop of a boat by ground stations: whoever is at one may stop it, as its commander, or else with the latched stop. Stations release that only if the one that
 * latched it could have commanded the boat, and no base has stopped it too; else a base has to. For the boat's thread.
 */
final class StationStop {
    private final BoatClient boat;
    private final CommandingStation command;
    private boolean releasable; // false after a restart of the boat too: who latched it is not known then

    StationStop(BoatClient boat, CommandingStation command) {
        this.boat = boat;
        this.command = command;
    }

    /** Stops the boat; why it refuses, empty where it does not. */
    Optional<String> stop(VehicleId station, long nowMs) {
        boolean could = command.whyNot(station, nowMs).isEmpty();
        if (isLatched()) {
            releasable &= could;
            return Optional.empty();
        } else if (command.isHolder(station)) {
            return boat.send(StopMotors::new, nowMs);
        } else if (could && boat.mode() == BoatMode.STOPPED) {
            return Optional.empty();
        }
        releasable = could;
        return boat.send(FleetStop::new, nowMs);
    }

    /** Whether the latched stop is in force, whoever latched it. */
    boolean isLatched() {
        return boat.mode() == BoatMode.FLEET_STOP;
    }

    /** By whom the boat is stopped, in words, where a station may not release it. */
    Optional<String> whyNotReleased() {
        String by = boat.settings().map(SettingsReport::stoppedBy).orElse("");
        if (!isLatched()) {
            return Optional.empty();
        } else if (!by.equals(BoatClient.NAME)) {
            return Optional.of("by " + (by.isEmpty() ? "a fleet stop" : by) + ": release it there");
        }
        return releasable
                ? boat.alsoStoppedBy().map(other -> "by " + other + " too: release it there")
                : Optional.of("until a base releases it");
    }

    /** Releases a latched stop. */
    void release(long nowMs) {
        if (isLatched()) {
            boat.send(FleetRelease::new, nowMs);
        }
    }
}
