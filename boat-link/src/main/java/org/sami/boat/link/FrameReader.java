package org.sami.boat.link;

import java.io.DataInputStream;
import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.util.Arrays;
import java.util.Optional;
import org.sami.boat.link.LinkException.Fault;

/**
 * Cuts frames out of a stream of bytes. It bounds the memory that a peer can make it use: it allocates no more than has arrived, whatever length a frame
 * declares.
 *
 * <p>After an exception the place in the stream is lost; the stream must be closed. For one thread at a time.
 */
public final class FrameReader {
    private static final int CHUNK_BYTES = 8192;

    private final DataInputStream in;
    private final int maxBytes;

    /** Reads from a stream, which the caller opens, buffers and closes; the codec gives the bound on frames. */
    public FrameReader(InputStream in, LinkCodec codec) {
        this.in = new DataInputStream(in);
        this.maxBytes = codec.maxBytes();
    }

    /**
     * The next whole frame, with its length, or empty at the end of the stream between two frames.
     *
     * @throws LinkException if the declared length is out of bounds or the stream ends in mid-frame
     * @throws IOException if the stream fails
     */
    public Optional<byte[]> next() throws IOException, LinkException {
        int first = in.read();
        if (first < 0) {
            return Optional.empty();
        }
        try {
            byte[] frame = new byte[LinkCodec.LENGTH_BYTES];
            frame[0] = (byte) first;
            in.readFully(frame, 1, LinkCodec.LENGTH_BYTES - 1);
            int declared = (first << 24) | (frame[1] & 0xff) << 16 | (frame[2] & 0xff) << 8 | (frame[3] & 0xff);
            LinkCodec.checkDeclared(declared, maxBytes);
            return Optional.of(body(frame, declared));
        } catch (EOFException e) {
            throw new LinkException(Fault.TRUNCATED, "", "the stream ends in mid-frame");
        }
    }

    private byte[] body(byte[] header, int declared) throws IOException {
        int total = header.length + declared;
        byte[] frame = Arrays.copyOf(header, Math.min(total, CHUNK_BYTES));
        int filled = header.length;
        while (filled < total) {
            if (filled == frame.length) {
                frame = Arrays.copyOf(frame, Math.min(total, 2 * frame.length));
            }
            in.readFully(frame, filled, frame.length - filled);
            filled = frame.length;
        }
        return frame;
    }
}
