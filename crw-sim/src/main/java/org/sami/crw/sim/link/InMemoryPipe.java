package org.sami.crw.sim.link;

import java.util.Objects;
import java.util.SplittableRandom;
import org.sami.boat.link.Frame;
import org.sami.boat.link.FrameSink;
import org.sami.boat.link.LinkCodec;
import org.sami.boat.link.LinkException;
import org.sami.crw.sim.clock.VirtualScheduler;

/**
 * One direction of a simulated link: what is sent arrives after a while of virtual time, in order, unless it is lost.
 *
 * <p>While the pipe is cut, nothing that is sent gets in; frames under way still arrive. Neither end is notified, as with a radio
 * out of range. Messages are immutable, so frames are passed as they are, unless the {@link PipeConfig} wants them written and read.
 */
public final class InMemoryPipe implements FrameSink {
    private final VirtualScheduler scheduler;
    private final PipeConfig config;
    private final SplittableRandom random;
    private FrameReceiver receiver = (frame, nowMs) -> {};
    private long lastArrivalMs;
    private boolean cut;
    private long delivered;
    private long lost;

    /** A pipe that delivers to nobody until it is connected. */
    public InMemoryPipe(VirtualScheduler scheduler, PipeConfig config, long seed) {
        this.scheduler = Objects.requireNonNull(scheduler, "scheduler");
        this.config = Objects.requireNonNull(config, "config");
        random = new SplittableRandom(seed);
    }

    /** From now on frames arrive here. */
    public void connect(FrameReceiver newReceiver) {
        receiver = Objects.requireNonNull(newReceiver, "receiver");
    }

    /** Cuts the pipe, or mends it. */
    public void setCut(boolean isCut) {
        cut = isCut;
    }

    /** How many frames have arrived. */
    public long delivered() {
        return delivered;
    }

    /** How many frames were sent in vain. */
    public long lost() {
        return lost;
    }

    /** Sends what is bytes already; what cannot be read is lost. */
    @Override
    public void send(byte[] bytes) {
        try {
            send(LinkCodec.STANDARD.decode(bytes));
        } catch (LinkException e) {
            lost++;
        }
    }

    @Override
    public void send(Frame frame) {
        if (cut || isLost()) {
            lost++;
            return;
        }
        long arrivalMs = scheduler.nowMs() + config.latencyMs() + jitter();
        lastArrivalMs = Math.max(lastArrivalMs, arrivalMs);
        Frame arriving = config.isCoded() ? writtenAndRead(frame) : frame;
        scheduler.at(lastArrivalMs, () -> deliver(arriving));
    }

    private static Frame writtenAndRead(Frame frame) {
        try {
            return LinkCodec.STANDARD.decode(LinkCodec.STANDARD.encode(frame));
        } catch (LinkException e) {
            throw new IllegalStateException("the codec does not read what it has written", e);
        }
    }

    private void deliver(Frame frame) {
        delivered++;
        receiver.receive(frame, scheduler.nowMs());
    }

    private boolean isLost() {
        return config.lossProbability() > 0 && random.nextDouble() < config.lossProbability();
    }

    private long jitter() {
        return config.jitterMs() > 0 ? random.nextLong(config.jitterMs() + 1) : 0;
    }
}
