package org.sami.crw.sim.link;

import org.sami.boat.link.Frame;

/** The far end of a pipe. */
@FunctionalInterface
public interface FrameReceiver {

    /** Takes one frame that has arrived at this virtual time. */
    void receive(Frame frame, long nowMs);
}
