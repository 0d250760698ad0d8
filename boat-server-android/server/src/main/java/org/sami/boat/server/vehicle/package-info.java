/**
 * The vehicle that the server drives, with its instruments, and the plane in metres on which it computes ways. A host implements {@link
 * org.sami.boat.server.vehicle.Vehicle}. Not here: how the vehicle is driven. Java 8 level.
 */
package org.sami.boat.server.vehicle;
