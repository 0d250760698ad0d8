/**
 * The boat server behind TCP: sockets, threads and bounded queues in front of a {@link
 * org.sami.boat.server.BoatServer}, which knows none of them.
 *
 * <p>One thread owns the boat: it ticks the server and passes it the frames of the readers. Each connection has a reader and a writer; neither ever makes
 * the boat or another client wait.
 *
 * <p>Not here: the effects of messages, the hull, Android. Java 8 level.
 */
package org.sami.boat.server.tcp;
