package org.sami.mavlink.testing;

import java.util.ArrayList;
import java.util.List;
import java.util.PriorityQueue;
import java.util.SplittableRandom;

/** One direction of a radio on a clock of the test's own: it takes time, loses, doubles and reorders. */
public final class BadRadio<T> {
    private final SplittableRandom random;
    private final double loss;
    private final double doubled;
    private final long takesMs;
    private final long moreMs;
    private final PriorityQueue<Flying<T>> flying = new PriorityQueue<>();
    private long number;

    private record Flying<T>(long arrivesMs, long number, T what) implements Comparable<Flying<T>> {
        @Override
        public int compareTo(Flying<T> other) {
            int byTime = Long.compare(arrivesMs, other.arrivesMs);
            return byTime == 0 ? Long.compare(number, other.number) : byTime;
        }
    }

    /**
     * A radio.
     *
     * @param loss the part that is lost, 0 to 1
     * @param doubled the part that comes twice, 0 to 1
     * @param takesMs how long each message takes at least
     * @param moreMs how much longer it takes at most, each its own: what is sent later may come earlier
     */
    public BadRadio(long seed, double loss, double doubled, long takesMs, long moreMs) {
        random = new SplittableRandom(seed);
        this.loss = loss;
        this.doubled = doubled;
        this.takesMs = takesMs;
        this.moreMs = moreMs;
    }

    /** Sends. */
    public void send(T what, long nowMs) {
        if (random.nextDouble() >= loss) {
            fly(what, nowMs);
            if (random.nextDouble() < doubled) {
                fly(what, nowMs);
            }
        }
    }

    private void fly(T what, long nowMs) {
        flying.add(new Flying<>(nowMs + takesMs + random.nextLong(moreMs + 1), number++, what));
    }

    /** What has arrived, in the order in which it did. */
    public List<T> arrived(long nowMs) {
        List<T> all = new ArrayList<>();
        while (!flying.isEmpty() && flying.peek().arrivesMs() <= nowMs) {
            all.add(flying.poll().what());
        }
        return all;
    }
}
