/**
 * The vehicle's end of MAVLink: what a boat of ours says and answers where a ground station of another maker talks to it.
 *
 * <p>Not here: what a boat does with a mission or a mode, which whoever makes it a vehicle says ({@code crw.cli.vehicle} for our boats).
 */
@NullMarked
package org.sami.mavlink.onboard;

import org.jspecify.annotations.NullMarked;
