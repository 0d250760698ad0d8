package org.sami.mavlink.link;

import io.dronefleet.mavlink.MavlinkMessage;
import org.sami.mavlink.address.MavlinkAddress;

/** Receives what comes on a link, on the link's reading thread. What it throws ends the link's thread: it must not throw. */
public interface MavlinkLinkListener {
    /** A message came on the link of an address. */
    void onMessage(MavlinkAddress from, MavlinkMessage<?> message);
}
