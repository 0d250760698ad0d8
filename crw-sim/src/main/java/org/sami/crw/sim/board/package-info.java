/**
 * A simulated control board on TCP, with a simulated hull and its GPS receiver: for tests and classes without a boat.
 *
 * <p>Not here: the boat that is driven through it ({@code org.sami.boat.hull}), simulated boats without a board ({@link org.sami.crw.sim.boat}).
 */
@NullMarked
package org.sami.crw.sim.board;

import org.jspecify.annotations.NullMarked;
