/**
 * One simulated boat on the time of this machine, behind TCP, with its log: what a boat's phone runs, with a simulated hull.
 *
 * <p>Not here: fleets in virtual time ({@link org.sami.crw.sim.fleet}), the command line.
 */
@NullMarked
package org.sami.crw.sim.boat;

import org.jspecify.annotations.NullMarked;
