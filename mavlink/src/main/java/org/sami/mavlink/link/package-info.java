/**
 * Links on which vehicles speak MAVLink: opened, kept open, read and written, with what is lost on them.
 *
 * <p>The library that knows the messages stands here and in {@code mavlink.vehicle} and {@code mavlink.mission}; its types leave this module nowhere. Not
 * here: what the messages mean for a vehicle.
 */
@NullMarked
package org.sami.mavlink.link;

import org.jspecify.annotations.NullMarked;
