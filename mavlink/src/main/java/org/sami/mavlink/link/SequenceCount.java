package org.sami.mavlink.link;

import java.util.HashMap;
import java.util.Map;

/** Counts the messages that came and those that are missing, by the numbers that each sender gives its messages: 0 to 255, then 0 again. */
final class SequenceCount {
    private static final int NUMBERS = 256;
    private static final int AT_ONCE = 128; // a gap that is wider is an older message, or a sender that began again

    private static final int FEW = 8;

    private final Map<Integer, Integer> next = new HashMap<>();
    private long came;
    private long missing;

    /** A message came from a component of a system. */
    void came(int system, int component, int number) {
        came++;
        int sender = system * NUMBERS + component;
        Integer expected = next.get(sender);
        int gap = expected == null ? 0 : Math.floorMod(number - expected, NUMBERS);
        if (gap < AT_ONCE) {
            missing += gap;
            next.put(sender, (number + 1) % NUMBERS);
        } else if (missing > 0) {
            missing--; // it was late, not lost
        }
    }

    /** Whether a message with a number is the next of a component that has sent before, or the one after few that are missing. */
    boolean isNext(int system, int component, int number) {
        Integer expected = next.get(system * NUMBERS + component);
        return expected != null && Math.floorMod(number - expected, NUMBERS) < FEW;
    }

    long messages() {
        return came;
    }

    /** The part of what was sent that did not come, 0 to 1. */
    double lost() {
        return came == 0 ? 0 : (double) missing / (came + missing);
    }
}
