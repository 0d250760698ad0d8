package org.sami.crw.proxy.command;

import org.sami.spn.protocol.Priority;

/** Motors to zero; complete when the boat says so. With {@code block} it keeps the boat where it is for its mission. */
public record Stop(String commandId, long mission, long activation, Priority priority, boolean block)
        implements BoatCommand {

    /** Refuses an empty id. */
    public Stop {
        CommandChecks.check(commandId, priority);
    }
}
