package org.sami.mavlink.base;

/**
 * A message that vehicles are asked to send.
 *
 * @param number its number (MAVLink message id)
 * @param payloadBytes the longest that its content can be
 * @param everyS how often, in seconds
 */
public record AskedMessage(int number, String name, int payloadBytes, double everyS) {
    private static final int FRAME_BYTES = 12; // of MAVLink 2
    private static final int SIGNATURE_BYTES = 13;

    /** What it costs on a link, bytes a second. */
    public double bytesPerSecond(boolean signed) {
        return (payloadBytes + FRAME_BYTES + (signed ? SIGNATURE_BYTES : 0)) / everyS;
    }

    AskedMessage slower(double factor) {
        return new AskedMessage(number, name, payloadBytes, everyS * factor);
    }
}
