package org.sami.mavlink.link;

import java.util.List;
import org.sami.mavlink.address.MavlinkAddress;

/** Receives what comes on a link, on the link's reading thread. What it throws ends the link's thread: it must not throw. */
public interface MavlinkLinkListener {
    /** Messages came on the link of an address, in this order; one or more. */
    void onMessages(MavlinkAddress from, List<ReceivedMessage> messages);
}
