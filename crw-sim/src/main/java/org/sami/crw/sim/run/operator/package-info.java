/**
 * What people do in a run: the simulated operator's answers, the interrupts that are pressed, the batteries that are swapped at the quay.
 *
 * <p>Does not belong here: what the simulated operator answers ({@code org.sami.crw.decision}), which interrupts a plan offers ({@code
 * settings}).
 */
@NullMarked
package org.sami.crw.sim.run.operator;

import org.jspecify.annotations.NullMarked;
