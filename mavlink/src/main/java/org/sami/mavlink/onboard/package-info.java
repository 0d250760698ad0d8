/**
 * A vehicle's own end of MAVLink: what a ground station is sent, and how its lists, parameters and commands are answered.
 *
 * <p>Not here: which vehicle that is and who may command it, which the {@code OnboardHost} knows; and the ground station's end, which is in {@code mavlink.base}.
 */
@NullMarked
package org.sami.mavlink.onboard;

import org.jspecify.annotations.NullMarked;
