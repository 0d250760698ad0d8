/**
 * A boat of ours in ground stations of other makers: a client of the boat's server, in the boat's own process, that speaks MAVLink for it.
 *
 * <p>Not here: the protocol itself, which is in {@code mavlink.onboard}; and vehicles of other makers in our bases, which are in {@code crw.mavlink}.
 */
@NullMarked
package org.sami.boat.mavlink;

import org.jspecify.annotations.NullMarked;
