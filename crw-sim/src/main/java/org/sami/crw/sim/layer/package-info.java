/**
 * What differs by place on the simulated water and does not change with time: its depth, from a grid, and its current, from points. Also the sonar that measures
 * the depth.
 *
 * <p>Does not belong here: conditions that are equal everywhere ({@code org.sami.crw.sim.hull}), and the map of what was measured.
 */
@NullMarked
package org.sami.crw.sim.layer;

import org.jspecify.annotations.NullMarked;
