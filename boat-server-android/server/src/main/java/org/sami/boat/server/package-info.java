/**
 * The boat server: what runs on a boat between the link and the hull.
 *
 * <p>{@link org.sami.boat.server.BoatServer} is a state machine without threads, sockets and clock: its host connects
 * sessions, hands it frames and ticks it ten times a second with a clock that never runs back. The hull is a
 * {@link org.sami.boat.server.vehicle.Vehicle}: the phone's motors and sensors, or a simulated hull.
 *
 * <p>Trigonometry is that of {@code StrictMath}, so that a simulated run is the same on every machine.
 *
 * <p>Not here: transports (they are {@link org.sami.boat.link.FrameSink}s), Android, simulation, missions. Java 8 level.
 */
package org.sami.boat.server;
