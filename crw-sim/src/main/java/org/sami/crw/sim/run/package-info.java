/**
 * Runs of missions: the harness of every run, whatever fleet it is on, and the fleet in process, with base, link, boats and operator in one
 * thread under the virtual clock (ARCHITECTURE.md).
 *
 * <p>Here belong the loop that drives such a fleet, the pacing of its time, its journal, and what starts and ends a run of any kind. In
 * packages of their own stand what is settled beforehand ({@code settings}), the water with its boats ({@code world}), what people do in
 * a run ({@code operator}), and the record of it ({@code record}). Hulls and links have packages of their own; what the report
 * looks like belongs to {@code org.sami.crw.report}, taking up a run that was killed to {@code org.sami.crw.sim.resume}, options to
 * {@code org.sami.crw.cli}.
 */
@NullMarked
package org.sami.crw.sim.run;

import org.jspecify.annotations.NullMarked;
