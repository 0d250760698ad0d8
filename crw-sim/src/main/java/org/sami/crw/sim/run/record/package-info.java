/**
 * What is noted down of a run, in process and over TCP: tracks, visits, tasks, readings, phases, what the operator was told, and the hash
 * of the run. {@link org.sami.crw.sim.run.record.RunRecords} puts it together and makes the report of it.
 *
 * <p>Does not belong here: the records of the report and how they look ({@code org.sami.crw.sim.report}).
 */
package org.sami.crw.sim.run.record;
