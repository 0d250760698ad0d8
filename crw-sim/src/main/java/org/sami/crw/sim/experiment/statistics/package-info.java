/**
 * Statistics of samples: mean, standard error, Student's t-tests.
 *
 * <p>Does not belong here: what is sampled.
 */
@NullMarked
package org.sami.crw.sim.experiment.statistics;

import org.jspecify.annotations.NullMarked;
