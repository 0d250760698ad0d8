package org.sami.mavlink.vehicle;

import org.sami.mavlink.address.MavlinkAddress;

/**
 * How a vehicle is heard on a link.
 *
 * @param lost the part of its messages that did not come there lately, 0 to 1
 * @param heardMs when it was heard there last, on the base's clock
 * @param slow whether it is no network all the way: a serial line, or one with a radio in it, as its address says or the radio reports
 */
public record HeardLink(MavlinkAddress link, double lost, long heardMs, boolean slow) {}
