/**
 * What lies below the server: the vehicle that it drives, with its instruments, and the plane in metres on which ways are computed. A host implements
 * {@link org.sami.boat.server.vehicle.Vehicle}. Not here: how it is driven. Java 8 level.
 */
package org.sami.boat.server.vehicle;
