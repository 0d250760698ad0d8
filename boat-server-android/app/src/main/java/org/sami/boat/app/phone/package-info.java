/**
 * The phone's parts for the boat: position sensors, the board's USB port, battery, heat, storage and date.
 *
 * <p>Not here: what the boat makes of it.
 */
package org.sami.boat.app.phone;
