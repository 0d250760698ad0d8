/**
 * The record of a run, in process, over TCP and from a journal: tracks, visits, tasks, readings, phases, messages to the operator,
 * and the hash of the run. Each is a {@link org.sami.crw.sim.run.record.ReportFold};
 * {@link org.sami.crw.sim.run.record.ReportFolds} is the list of them and makes the report.
 *
 * <p>Does not belong here: the records of the report and how they look ({@code org.sami.crw.report}).
 */
@NullMarked
package org.sami.crw.sim.run.record;

import org.jspecify.annotations.NullMarked;
