package org.sami.crw.proxy.command;

import org.sami.boat.link.TakePanorama;
import org.sami.spn.protocol.Priority;

/** Keep station, turn all round and take pictures; complete when they are taken. */
public record Panorama(String commandId, long mission, long activation, int pictures, Priority priority)
        implements BoatCommand {

    /** Refuses a number of pictures that no boat takes. */
    public Panorama {
        CommandChecks.check(commandId, priority);
        if (pictures < 1 || pictures > TakePanorama.MAX_PICTURES) {
            throw new IllegalArgumentException(pictures + " pictures");
        }
    }

    @Override
    public boolean block() {
        return false;
    }
}
