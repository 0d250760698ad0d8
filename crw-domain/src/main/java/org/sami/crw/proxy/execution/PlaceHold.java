package org.sami.crw.proxy.execution;

import java.util.Optional;
import org.sami.crw.proxy.command.BoatCommand;
import org.sami.crw.proxy.command.KeepStation;
import org.sami.crw.proxy.queue.QueuedCommand;
import org.sami.spn.protocol.Priority;
import org.sami.spn.value.GeoPoint;

/**
 * Keeps a boat whose path was given up at its place, or at the nearest place outside no-go areas, until somebody decides (docs/services.md). No
 * mission asked for it: it comes after every command and is in no queue.
 */
final class PlaceHold {

    private Optional<QueuedCommand> station = Optional.empty();

    /** The station to be kept while no mission wants anything of the boat. */
    Optional<QueuedCommand> station() {
        return station;
    }

    /** Whether a command is the station, and no mission's. */
    boolean is(QueuedCommand queued) {
        return station.isPresent() && station.get() == queued;
    }

    /** Begins for a boat that is there, and whose command was given up. */
    void begin(BoatCommand givenUp, GeoPoint at) {
        GeoPoint place = givenUp.water()
                .map(water -> water.outside(at, water.margin().pathM()))
                .orElse(at);
        KeepStation keep = new KeepStation(
                givenUp.commandId() + "-hold",
                givenUp.mission(),
                givenUp.activation(),
                place,
                CommandDefaults.PLACE_RADIUS_M, // the boat itself keeps closer, where it can
                Priority.LOW,
                false,
                givenUp.water());
        station = Optional.of(new QueuedCommand(keep, 0));
    }

    /** Ends for good. */
    void end() {
        station = Optional.empty();
    }

    /** Ends if it was begun for a command of that mission. */
    void end(long mission) {
        station = station.filter(queued -> queued.command().mission() != mission);
    }
}
