/**
 * Position, heading and speed of a hull from GPS, compass and gyro.
 *
 * <p>Not here: how receivers are read.
 */
package org.sami.boat.hull.position;
