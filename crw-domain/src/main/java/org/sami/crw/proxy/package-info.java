/**
 * Boat proxies: the base's side of the boat link, and the queue of commands that missions have for a boat (docs/link.md; decision 0040).
 *
 * <p>A {@link org.sami.crw.proxy.BoatProxy} has no thread, socket or clock of its own: its host passes it frames and ticks it ten times a second, and
 * it reports on the caller's thread. Missions queue commands and withdraw them; the proxy makes the boat execute the right one, across lost links and
 * restarts.
 *
 * <p>Here: the composition of a proxy, its settings and hand-over, and the registry of a base's proxies. The parts have a package for each subject;
 * none of them knows this one:
 *
 * <ul>
 *   <li>{@code status}: reports of boats;
 *   <li>{@code command}: commands; {@code queue}: their order; {@code execution}: their execution;
 *   <li>{@code link}: hello, heartbeat and requests;
 *   <li>{@code listener}: notifications; {@code explanation}: why a boat moves or does not, in words;
 *   <li>{@code tcp}: links over TCP. Only this package knows proxies.
 * </ul>
 *
 * <p>Not here: transports, the engine, the meaning of a plan's events.
 */
@NullMarked
package org.sami.crw.proxy;

import org.jspecify.annotations.NullMarked;
