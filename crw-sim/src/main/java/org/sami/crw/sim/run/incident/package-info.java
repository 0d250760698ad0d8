/**
 * Runs with incidents: missions in simulated water, an operator who follows a script, and incidents at drawn times, of batteries, or of boats inside an area
 * (thesis 7.1.1).
 *
 * <p>Does not belong here: which runs an experiment makes, and its tables ({@code org.sami.crw.sim.experiment.table}).
 */
@NullMarked
package org.sami.crw.sim.run.incident;

import org.jspecify.annotations.NullMarked;
