package org.sami.crw.sim.link;

/** The far end of a pipe. */
@FunctionalInterface
public interface FrameReceiver {

    /** Takes one whole frame that has arrived at this virtual time. */
    void receive(byte[] frame, long nowMs);
}
