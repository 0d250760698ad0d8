/**
 * Boat proxies: the base's side of the boat link, and the queue of commands that missions have for a boat (docs/link.md;
 * decision 0040).
 *
 * <p>A {@link org.sami.crw.proxy.BoatProxy} has no thread, socket or clock of its own: its host hands it frames and ticks it
 * ten times a second, and everything it reports is reported on the caller's thread. Missions hand it commands and
 * withdraw them; it does what must be done for the boat to carry out the right one, across lost links and restarts.
 *
 * <p>Not here: transports, the engine, what an event of a plan means.
 */
package org.sami.crw.proxy;
