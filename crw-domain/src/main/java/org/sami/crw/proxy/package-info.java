/**
 * Boat proxies: the base's side of the boat link, and the queue of commands that missions have for a boat (docs/link.md;
 * decision 0040).
 *
 * <p>A {@link org.sami.crw.proxy.BoatProxy} has no thread, socket or clock of its own: its host hands it frames and ticks it
 * ten times a second, and everything it reports is reported on the caller's thread. Missions hand it commands and
 * withdraw them; it does what must be done for the boat to carry out the right one, across lost links and restarts.
 *
 * <p>Here stands what puts a proxy together, what is set on a boat and who commands it, and what knows all proxies of a base. The parts
 * stand in a package for each subject; none of them knows this one:
 *
 * <ul>
 *   <li>{@code status}: what boats say of themselves;
 *   <li>{@code command}: what they are to do; {@code queue}: whose turn it is; {@code execution}: how a boat is brought to do it;
 *   <li>{@code link}: hello, heartbeat and requests;
 *   <li>{@code listener}: what proxies tell; {@code explanation}: why a boat moves or does not, in words;
 *   <li>{@code tcp}: links over TCP. It alone is above: it knows proxies.
 * </ul>
 *
 * <p>Not here: transports, the engine, what an event of a plan means.
 */
package org.sami.crw.proxy;
