/**
 * Vessels on the simulated water that are not of the base's fleet, and objects that drift there: where they are at a time, and what a boat sees of them.
 *
 * <p>Does not belong here: how boats give way to them ({@code org.sami.boat.server.traffic}), and what the operator is shown of them.
 */
@NullMarked
package org.sami.crw.sim.vessel;

import org.jspecify.annotations.NullMarked;
