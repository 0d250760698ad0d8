/**
 * The domain's handlers: one for each output event that is neither a decision nor the engine's own, and the reports of boats as news to plans. {@link
 * org.sami.crw.handler.CrwDomain} puts all handlers on a host.
 *
 * <p>Here: that composition, and handlers of events that do not move boats (messages, tasks, unknown requests of imported plans). The others have a
 * package for each subject, in the order in which they know each other:
 *
 * <ul>
 *   <li>{@code activation}: fields, boats and answers of an activation;
 *   <li>{@code subscription}: measurements and positions of boats, reported to plans that wait for them;
 *   <li>{@code motion}: commands that move, hold or stop boats;
 *   <li>{@code planning}: computations of services: allocations, ways, places, exploration;
 *   <li>{@code boat}: boats that join, are configured, change hands or report.
 * </ul>
 *
 * <p>Not here: keeping a boat at its command ({@code org.sami.crw.proxy}), the computations themselves ({@code org.sami.crw.service}).
 */
@NullMarked
package org.sami.crw.handler;

import org.jspecify.annotations.NullMarked;
