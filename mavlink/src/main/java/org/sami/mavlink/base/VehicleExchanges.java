package org.sami.mavlink.base;

import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import org.sami.mavlink.command.PendingCommands;
import org.sami.mavlink.mission.HeldLists;
import org.sami.mavlink.param.ParameterFiles;
import org.sami.mavlink.param.VehicleParameters;
import org.sami.mavlink.vehicle.VehicleEvent;
import org.sami.mavlink.vehicle.VehicleId;

/** What is asked of one vehicle and not answered yet: commands, lists and parameters. Used by one thread. */
final class VehicleExchanges {
    private final PendingCommands commands;
    private final HeldLists lists;
    private final VehicleParameters parameters;

    VehicleExchanges(VehicleId vehicle, Optional<ParameterFiles> files, Consumer<Object> send) {
        commands = new PendingCommands(vehicle, send);
        lists = new HeldLists(vehicle, send);
        parameters =
                new VehicleParameters(vehicle, values -> files.ifPresent(kept -> kept.keep(vehicle, values)), send);
    }

    PendingCommands commands() {
        return commands;
    }

    HeldLists lists() {
        return lists;
    }

    VehicleParameters parameters() {
        return parameters;
    }

    /**
     * Takes what the vehicle sent, and what happened to it by that.
     *
     * @param number the vehicle's number of the message
     */
    void take(Object message, int number, List<VehicleEvent> events, long nowMs) {
        for (VehicleEvent event : events) {
            if (event instanceof VehicleEvent.Said said) {
                commands.heard(said.text());
            } else if (event instanceof VehicleEvent.Restarted) {
                restarted();
            }
        }
        if (AnswerTargets.isForAnother(message)) {
            return; // else a disarm would end with the answer to a pilot who arms
        }
        commands.take(message, nowMs);
        lists.take(message, number, nowMs);
        parameters.take(message, nowMs);
    }

    /** Its autopilot has started again: what it holds may be another. */
    void restarted() {
        lists.forget();
    }

    void tick(long nowMs) {
        commands.tick(nowMs);
        lists.tick(nowMs);
        parameters.tick(nowMs);
    }

    void close() {
        commands.close();
        lists.close();
        parameters.close();
    }
}
