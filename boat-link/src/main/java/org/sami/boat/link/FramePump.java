package org.sami.boat.link;

import java.io.BufferedInputStream;
import java.io.BufferedOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.util.Optional;
import java.util.concurrent.Semaphore;

/**
 * Both directions of the frames of one peer, bounded. What is sent waits in a queue, so that nobody ever waits for the peer;
 * what the peer sends is handed on as long as it is taken, and then the peer waits.
 *
 * <p>Its owner gives it the streams, a thread for each direction, and an interrupt of the reading one at the end. Safe for use
 * by several threads.
 */
public final class FramePump {
    /** Bytes of the peer that may wait to be taken: more than the largest frame. */
    private static final int MAX_UNREAD_BYTES = 2 * LinkCodec.DEFAULT_MAX_BYTES;

    /** What a frame counts for at least: so that not many small ones wait either. */
    private static final int LEAST_UNREAD_BYTES = MAX_UNREAD_BYTES / 64;

    /** Takes what the peer sends. */
    public interface Taker {
        /** A whole frame has come; {@code done} is to be run once it has been taken. */
        void arrived(byte[] frame, Runnable done);
    }

    private final FrameQueue queue;
    private final Semaphore unread = new Semaphore(MAX_UNREAD_BYTES);

    /** A pump that keeps so many frames, and so many bytes of them, for a peer that does not read. */
    public FramePump(int maxFrames, int maxBytes) {
        queue = new FrameQueue(maxFrames, maxBytes);
    }

    /** Puts a frame on its way. Returns false if the peer lets too much wait; the link is then to be closed. */
    public boolean send(byte[] frame) {
        return queue.offer(frame);
    }

    /** Puts a frame on its way as soon as no other waits. Returns false, and takes nothing, while an earlier one of these waits. */
    public boolean sendBelow(byte[] frame) {
        return queue.offerBelow(frame);
    }

    /** Sends nothing more, and lets {@link #write} end when what waits has been written. */
    public void finish() {
        queue.finish();
    }

    /** Forgets what waits to be sent, and lets {@link #write} end. */
    public void close() {
        queue.close();
    }

    /**
     * Hands on frame after frame; returns at the end of the stream between two of them.
     *
     * @throws LinkException if something is no frame; the place in the stream is lost
     */
    public void read(InputStream stream, Taker taker) throws IOException, LinkException, InterruptedException {
        FrameReader frames = new FrameReader(new BufferedInputStream(stream), new LinkCodec());
        for (Optional<byte[]> next = frames.next(); next.isPresent(); next = frames.next()) {
            int counted = Math.max(LEAST_UNREAD_BYTES, next.get().length);
            unread.acquire(counted);
            taker.arrived(next.get(), () -> unread.release(counted));
        }
    }

    /** Writes what is sent, until {@link #finish} or {@link #close}. */
    public void write(OutputStream stream) throws IOException, InterruptedException {
        OutputStream out = new BufferedOutputStream(stream);
        for (Optional<byte[]> next = queue.take(); next.isPresent(); next = queue.take()) {
            out.write(next.get());
            if (queue.isEmpty()) {
                out.flush();
            }
        }
    }
}
