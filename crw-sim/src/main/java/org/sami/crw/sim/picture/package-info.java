/**
 * What the cameras of simulated boats see: a picture drawn from where the boat is, how it heads, the clock, the other boats and the seed of the water. Equal
 * {@link org.sami.crw.sim.picture.Scene}s give equal pictures on one machine. Headless Java2D. Not here: how pictures are kept and leave the boat.
 */
@NullMarked
package org.sami.crw.sim.picture;

import org.jspecify.annotations.NullMarked;
