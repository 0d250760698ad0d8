/**
 * The pictures that a boat keeps on board: a folder with a bound. Not here: cameras, which the host gives with its {@link
 * org.sami.boat.server.vehicle.Vehicle}, and how pictures leave the boat. Java 8 level.
 */
package org.sami.boat.server.picture;
