/**
 * Statistics of missions from the journals of sessions, as the thesis has them of field sessions (6.3).
 *
 * <p>Here belong the figures of single missions, those of a plan's missions together, and their text, CSV and JSON. Does not belong here: how a journal
 * is read ({@code org.sami.crw.sim.run.record}).
 */
@NullMarked
package org.sami.crw.report.statistics;

import org.jspecify.annotations.NullMarked;
