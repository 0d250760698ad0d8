package org.sami.crw.mavlink;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.sami.mavlink.address.MavlinkAddress;
import org.sami.mavlink.link.MavlinkLinkReport;
import org.sami.mavlink.link.MavlinkLinkState;

/** Finds links that stay broken, such as that of a radio that was pulled out: each once, until it is open again. For the gateway's thread. */
final class BrokenLinks {
    private static final int LOOKS = 2; // one that is open again at the next look needs nobody

    private final Map<MavlinkAddress, Integer> broken = new HashMap<>(); // in so many looks, one after the other

    /** Those that are found broken at this look for the second time in a row. To be called once a second. */
    List<MavlinkLinkReport> found(List<MavlinkLinkReport> links) {
        return links.stream()
                .filter(link -> {
                    if (link.state() != MavlinkLinkState.BROKEN) {
                        broken.remove(link.address());
                        return false;
                    }
                    return broken.merge(link.address(), 1, Integer::sum) == LOOKS;
                })
                .toList();
    }
}
