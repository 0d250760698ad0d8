/**
 * What the domain does when a plan asks: one handler for each output event that is neither a decision nor the engine's own, and what
 * boats report as news to plans. {@link org.sami.crw.handler.CrwDomain} puts all handlers on a host.
 *
 * <p>Belongs here: that composition, and handlers of events that concern no boat's way (messages, tasks, requests of imported plans that
 * are unknown). The others stand in a package for each subject, in the order in which they know each other:
 *
 * <ul>
 *   <li>{@code activation}: what an activation says, to whom, and how it is answered;
 *   <li>{@code subscription}: what boats measure and where they are, told to plans as long as they wait for it;
 *   <li>{@code motion}: commands that move boats, hold or stop them;
 *   <li>{@code planning}: what services compute: allocations, ways, places, exploration;
 *   <li>{@code boat}: boats that join, are set up, change hands or report.
 * </ul>
 *
 * <p>Does not belong here: how a boat is kept at its command ({@code org.sami.crw.proxy}), algorithms ({@code org.sami.crw.service}),
 * firing rules. What is public in those packages is so for {@code CrwDomain} alone.
 *
 * <p>Threads: all handlers, and all that is heard of boats, run on one serial executor, the one that drives the proxies ("the fleet's
 * thread"). So nothing here is locked. What comes from the engine's thread is handed over to it.
 */
package org.sami.crw.handler;
