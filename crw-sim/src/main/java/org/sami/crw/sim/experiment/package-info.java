/**
 * Experiments: the same missions with many seeds and in several conditions, side by side on all cores, and what came of them as a table.
 * How a single run goes is {@code org.sami.crw.sim.run}'s; how an experiment is asked for, the command line's.
 */
@NullMarked
package org.sami.crw.sim.experiment;

import org.jspecify.annotations.NullMarked;
