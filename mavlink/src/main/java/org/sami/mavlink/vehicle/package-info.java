/**
 * What vehicles report of themselves: kind, mode, position, battery, GPS, the autopilot's own words.
 *
 * <p>A vehicle here is any autopilot on a link. What a plan may ask of it is not here.
 */
@NullMarked
package org.sami.mavlink.vehicle;

import org.jspecify.annotations.NullMarked;
