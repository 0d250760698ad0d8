/**
 * Boats that join, are set up, change hands or report: handlers of those events, the questions that the operator is asked about single
 * boats, and what the session's journal remembers of a boat.
 *
 * <p>Does not belong here: commands that move boats ({@code motion}), links and queues ({@code org.sami.crw.proxy}).
 */
@NullMarked
package org.sami.crw.handler.boat;

import org.jspecify.annotations.NullMarked;
