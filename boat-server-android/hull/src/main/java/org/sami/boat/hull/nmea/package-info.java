/**
 * Readers of GPS receivers: NMEA 0183 sentences, and the reports of gpsd.
 *
 * <p>Not here: ports and sockets.
 */
package org.sami.boat.hull.nmea;
