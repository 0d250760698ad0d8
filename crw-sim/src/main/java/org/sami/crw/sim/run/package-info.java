/**
 * Runs in process: base, link, boats and operator in one thread under the virtual clock (decision 0051).
 *
 * <p>Here belong the world of such a run, the loop that drives it, the pacing of its time, and what is noted down while
 * it goes. Hulls and links have packages of their own; what the report looks like belongs to {@code crw.sim.report},
 * taking up a run that was killed to {@code crw.sim.resume}, options to {@code crw.sim.cli}.
 */
package org.sami.crw.sim.run;
