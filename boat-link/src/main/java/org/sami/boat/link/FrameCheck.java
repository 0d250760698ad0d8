package org.sami.boat.link;

import java.util.zip.CRC32;

/**
 * The check value of a frame: CRC-32 (as in Ethernet) of all its bytes but the check value itself. CRC-32C would be as good, and comes
 * only with Java 9.
 */
final class FrameCheck {

    private FrameCheck() {}

    /** The check value of a whole frame, whatever stands at its place. */
    static int of(byte[] frame) {
        CRC32 check = new CRC32();
        check.update(frame, 0, LinkCodec.CHECK_AT);
        check.update(frame, LinkCodec.HEADER_BYTES, frame.length - LinkCodec.HEADER_BYTES);
        return (int) check.getValue();
    }
}
