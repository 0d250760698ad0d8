package org.sami.session.api;

import java.util.Objects;
import org.sami.crw.proxy.tcp.BoatAddress;

/**
 * A boat to which the session's machine has a link, or had one that it makes again.
 *
 * @param boat its id
 * @param address where it answers, as seen from that machine
 */
public record LinkedBoat(String boat, BoatAddress address) {
    public LinkedBoat {
        Objects.requireNonNull(boat, "boat");
        Objects.requireNonNull(address, "address");
    }
}
