/**
 * The part of a run in process that is not the base: the water and the boats on it.
 *
 * <p>Does not belong here: how one boat moves and measures ({@code org.sami.crw.sim.hull}), its link ({@code org.sami.crw.sim.link}).
 */
@NullMarked
package org.sami.crw.sim.run.world;

import org.jspecify.annotations.NullMarked;
