package org.sami.mavlink.vehicle;

import java.util.Objects;
import org.sami.mavlink.address.MavlinkAddress;

/**
 * Where a message came from.
 *
 * @param number the sender's sequence number: 0 to 255, then 0 again
 */
public record MessageOrigin(MavlinkAddress link, int system, int component, int number) {
    /** An origin. */
    public MessageOrigin {
        Objects.requireNonNull(link, "link");
    }
}
