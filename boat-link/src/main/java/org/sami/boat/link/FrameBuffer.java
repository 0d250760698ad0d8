package org.sami.boat.link;

import java.io.ByteArrayOutputStream;
import java.nio.ByteBuffer;

/** Collects a frame behind a header whose length and check value are known only at the end. */
final class FrameBuffer extends ByteArrayOutputStream {

    FrameBuffer() {
        super(256);
        count = LinkCodec.HEADER_BYTES;
    }

    byte[] toFrame() {
        byte[] frame = toByteArray();
        ByteBuffer header = ByteBuffer.wrap(frame);
        header.putInt(frame.length - LinkCodec.LENGTH_BYTES).put((byte) LinkCodec.VERSION);
        header.putInt(FrameCheck.of(frame));
        return frame;
    }
}
