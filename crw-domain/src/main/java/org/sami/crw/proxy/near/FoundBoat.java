package org.sami.crw.proxy.near;

import org.sami.boat.link.BoatAnnouncement;
import org.sami.crw.proxy.tcp.BoatAddress;

/**
 * A boat that announces itself, which proves nothing: only its key does, when it is connected.
 *
 * @param announcement what it says
 * @param address where its server listens
 */
public record FoundBoat(BoatAnnouncement announcement, BoatAddress address) {}
