/**
 * Experiments of the thesis's kind: versions of a mission that are compared in configurations, with the same locations, batteries and incidents, and the
 * table of what came of them (thesis 7.1 and 8.2). An experiment is a file.
 *
 * <p>Does not belong here: how one run goes ({@code org.sami.crw.sim.run.incident}), what a mean or a test is ({@code statistics}).
 */
@NullMarked
package org.sami.crw.sim.experiment.table;

import org.jspecify.annotations.NullMarked;
