package org.sami.boat.server;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.zip.CRC32;
import org.sami.boat.link.LinkCodec;

/** Frames around any body: length, version and check value are right, whatever the body is. */
public final class FrameBytes {

    private FrameBytes() {}

    /** A frame around a text. */
    public static byte[] of(String body) {
        return of(body.getBytes(StandardCharsets.UTF_8));
    }

    /** A frame around bytes. */
    public static byte[] of(byte[] body) {
        byte[] start = ByteBuffer.allocate(5)
                .putInt(5 + body.length)
                .put((byte) LinkCodec.VERSION)
                .array();
        CRC32 check = new CRC32();
        check.update(start);
        check.update(body);
        return ByteBuffer.allocate(9 + body.length)
                .put(start)
                .putInt((int) check.getValue())
                .put(body)
                .array();
    }
}
