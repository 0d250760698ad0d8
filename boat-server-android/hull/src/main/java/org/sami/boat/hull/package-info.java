/**
 * A real hull without Android: control board, position, settings of the hull. The phone's app and {@code crw boat} use it alike.
 *
 * <p>Not here: Android, serial ports, the boat server, simulation. Java 8 level.
 */
package org.sami.boat.hull;
