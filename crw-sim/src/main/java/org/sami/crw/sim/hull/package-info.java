/**
 * Simulated hulls: how a boat moves for the efforts of its motors, and what that costs its battery.
 *
 * <p>{@link org.sami.crw.sim.hull.Conditions} says what current, wind, errors of instruments and sensors there are; by default
 * there are none. The hull is the truth, {@link org.sami.crw.sim.hull.Instruments} what its server knows of it.
 *
 * <p>A hull stands behind the same boat server that runs on the phone. Not here: control, links, missions.
 */
@NullMarked
package org.sami.crw.sim.hull;

import org.jspecify.annotations.NullMarked;
