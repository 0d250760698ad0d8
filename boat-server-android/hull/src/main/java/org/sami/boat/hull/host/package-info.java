/**
 * A real boat put together: control board, GPS, boat server, its TCP port and its log.
 *
 * <p>Not here: Android, serial ports, the command line.
 */
package org.sami.boat.hull.host;
