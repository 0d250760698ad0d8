/**
 * The boat link: the messages between base and boat and their codec on byte arrays and streams.
 *
 * <p>A frame is a length (four bytes, big endian, of what follows), a version byte, a check value (four bytes) and a body: one JSON
 * object in UTF-8 with {@code type}, {@code seq}, {@code term} and the members of that type. {@link org.sami.boat.link.LinkCodec} writes and reads
 * frames, {@link org.sami.boat.link.FrameReader} cuts them out of a stream, and a
 * {@link org.sami.boat.link.FrameSink} stands for the transport. A reader ignores unknown members, so that a newer peer can add some.
 *
 * <p>Units are SI: metres, metres per second, milliseconds; headings are radians clockwise from true north; positions are
 * WGS 84 latitude and longitude in degrees. Messages are immutable and check their values when they are made.
 *
 * <p>{@link org.sami.boat.link.SteadyClock} is the clock of both ends; {@link org.sami.boat.link.FramePump} bounds both directions of a link.
 *
 * <p>Not here: sockets, resending, and how boats and proxies act on messages. Java 8 level, because it runs on the phone in the hull.
 */
package org.sami.boat.link;
