package org.sami.boat.link;

/**
 * Takes the outgoing frames of one end of a link: a socket's writer, or the simulator's pipe in memory.
 *
 * <p>Bytes are whole frames as {@link LinkCodec#encode} makes them, and belong to the sink once sent. A sink does not
 * block and does not throw for a link that is down: what cannot be sent is lost, and the host of the link reports the
 * loss.
 */
public interface FrameSink {

    /** Sends one whole frame, in order with the others. */
    void send(byte[] frame);

    /**
     * Sends one frame after all others that wait, for what must delay nothing else. A sink without a queue sends it at once.
     *
     * @return false, and nothing is sent, while an earlier frame of this kind waits
     */
    default boolean sendBelow(Frame frame) {
        send(frame);
        return true;
    }

    /** Sends one frame, in order with the others, as the standard codec writes it; a sink that needs no bytes takes it as it is. */
    default void send(Frame frame) {
        send(LinkCodec.STANDARD.encode(frame));
    }
}
