package org.sami.mavlink.link;

import io.dronefleet.mavlink.MavlinkMessage;

/** Receives what comes on a link, on the link's reading thread. What it throws ends the link's thread: it must not throw. */
public interface MavlinkLinkListener {
    /** A message came. */
    void onMessage(MavlinkLink link, MavlinkMessage<?> message);
}
