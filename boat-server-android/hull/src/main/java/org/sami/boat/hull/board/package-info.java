/**
 * The control board of a hull: its lines of JSON, its link, its motors, battery and sensors. It is a vehicle of
 * the boat server.
 *
 * <p>Not here: where the streams come from (USB accessory, TCP, serial port), the position.
 */
package org.sami.boat.hull.board;
