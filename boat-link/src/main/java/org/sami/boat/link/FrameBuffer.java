package org.sami.boat.link;

import java.io.ByteArrayOutputStream;

/** Collects a frame behind a header whose length is known only at the end. */
final class FrameBuffer extends ByteArrayOutputStream {

    FrameBuffer() {
        super(256);
        count = LinkCodec.LENGTH_BYTES;
        write(LinkCodec.VERSION);
    }

    byte[] toFrame() {
        int length = count - LinkCodec.LENGTH_BYTES;
        buf[0] = (byte) (length >>> 24);
        buf[1] = (byte) (length >>> 16);
        buf[2] = (byte) (length >>> 8);
        buf[3] = (byte) length;
        return toByteArray();
    }
}
