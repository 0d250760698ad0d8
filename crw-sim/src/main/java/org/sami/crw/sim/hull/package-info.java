/**
 * Simulated hulls: how a boat moves for the efforts of its motors, and what that costs its battery.
 *
 * <p>A hull stands behind the same boat server that runs on the phone. Not here: control, links, missions.
 */
package org.sami.crw.sim.hull;
