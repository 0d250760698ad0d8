/**
 * The boat server behind TCP: sockets, threads and bounded queues in front of a {@link
 * org.sami.boat.server.BoatServer}, which knows none of them.
 *
 * <p>One thread owns the boat: it ticks the server and hands it what readers have cut out of the streams. Each connection
 * has a reader and a writer; neither ever keeps the boat or another client waiting.
 *
 * <p>Not here: what a message makes the boat do, the hull, Android. Java 8 level.
 */
package org.sami.boat.server.tcp;
