package org.sami.crw.proxy.tcp;

import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.concurrent.atomic.AtomicLong;
import java.util.concurrent.locks.LockSupport;
import java.util.function.LongSupplier;
import org.sami.boat.link.LinkCodec;
import org.sami.boat.link.RateLimit;

/**
 * Keeps excess frames of one boat from the base's thread, which all links share. It looks at the beginning of a frame only, on the thread that reads
 * from the boat. Readings, poses and command requests in excess are left out unread, and counted. For all other frames the reading waits, so that
 * nothing is lost. {@link org.sami.crw.proxy.link.Intake} limits and reports the rest.
 */
final class ExcessFrames {
    /** Frames a second of each sort: several times what a boat of this system sends with all its sensors. */
    private static final double PER_SECOND = 1000;

    private static final double BURST = 4000;
    private static final long PAUSE_NANOS = 1_000_000;
    private static final List<byte[]> CHATTER =
            List.of(beginning("reading"), beginning("telemetry"), beginning("motion"), beginning("command-asked"));

    private final LongSupplier nowMs;
    private final RateLimit chatter = new RateLimit(PER_SECOND, BURST);
    private final RateLimit others = new RateLimit(PER_SECOND, BURST);
    private final AtomicLong leftOut = new AtomicLong();

    /**
     * Nothing has come yet.
     *
     * @param nowMs a clock that never runs back
     */
    ExcessFrames(LongSupplier nowMs) {
        this.nowMs = nowMs;
    }

    /** Whether a frame is to be left out; waits a little where it is not and yet comes too fast. */
    boolean isExcess(byte[] frame) {
        if (isChatter(frame)) {
            boolean excess = !chatter.take(nowMs.getAsLong());
            if (excess) {
                leftOut.incrementAndGet();
            }
            return excess;
        }
        if (!others.take(nowMs.getAsLong())) {
            LockSupport.parkNanos(PAUSE_NANOS);
        }
        return false;
    }

    /** How many frames were left out since this was asked last. From any thread. */
    long takeLeftOut() {
        return leftOut.getAndSet(0);
    }

    private static boolean isChatter(byte[] frame) {
        return CHATTER.stream().anyMatch(beginning -> begins(frame, beginning));
    }

    private static boolean begins(byte[] frame, byte[] beginning) {
        if (frame.length < LinkCodec.HEADER_BYTES + beginning.length) {
            return false;
        }
        for (int i = 0; i < beginning.length; i++) {
            if (frame[LinkCodec.HEADER_BYTES + i] != beginning[i]) {
                return false;
            }
        }
        return true;
    }

    /** As the codec writes it; a frame written otherwise is no chatter, and waits. */
    private static byte[] beginning(String type) {
        return ("{\"type\":\"" + type + "\",").getBytes(StandardCharsets.US_ASCII);
    }
}
