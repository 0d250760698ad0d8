package org.sami.boat.link;

import java.util.ArrayDeque;
import java.util.Optional;

/**
 * The frames that wait for a peer to take them: bounded, in order, closed once and for all. A writer takes them on a thread of
 * its own; who sends never waits. Safe for use by several threads.
 */
final class FrameQueue {
    private final ArrayDeque<byte[]> frames = new ArrayDeque<>();
    private Optional<byte[]> below = Optional.empty(); // waits for all others
    private final int maxFrames;
    private final int maxBytes;
    private long bytes;
    private boolean finished;
    private boolean closed;

    /** A queue for so many frames and so many bytes of them. */
    FrameQueue(int maxFrames, int maxBytes) {
        this.maxFrames = maxFrames;
        this.maxBytes = maxBytes;
    }

    /** Adds a frame. Returns false, and takes nothing, if it does not fit; a single frame always fits. One that was finished or closed takes nothing. */
    synchronized boolean offer(byte[] frame) {
        boolean fits = frames.isEmpty() || (frames.size() < maxFrames && bytes + frame.length <= maxBytes);
        if (fits && !closed && !finished) {
            frames.add(frame);
            bytes += frame.length;
            notifyAll();
        }
        return fits;
    }

    /** Adds a frame that waits until no other does. Returns false, and takes nothing, while an earlier one waits. */
    synchronized boolean offerBelow(byte[] frame) {
        boolean fits = !below.isPresent();
        if (fits && !closed && !finished) {
            below = Optional.of(frame);
            notifyAll();
        }
        return fits;
    }

    /** The next frame, waited for; empty once the queue is closed, or was finished and nothing waits. */
    synchronized Optional<byte[]> take() throws InterruptedException {
        while (frames.isEmpty() && !below.isPresent() && !closed && !finished) {
            wait();
        }
        if (frames.isEmpty()) {
            Optional<byte[]> last = below;
            below = Optional.empty();
            return last;
        }
        byte[] frame = frames.remove();
        bytes -= frame.length;
        return Optional.of(frame);
    }

    /** Whether nothing waits, but for a frame that waits for all others. */
    synchronized boolean isEmpty() {
        return frames.isEmpty();
    }

    /** Takes nothing more; what waits can still be taken. */
    synchronized void finish() {
        finished = true;
        notifyAll();
    }

    /** Forgets what waits and takes nothing more. */
    synchronized void close() {
        closed = true;
        frames.clear();
        below = Optional.empty();
        bytes = 0;
        notifyAll();
    }
}
