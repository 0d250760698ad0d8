package org.sami.mavlink.mission;

import io.dronefleet.mavlink.common.MissionAck;
import java.util.HashMap;
import java.util.Map;

/**
 * Recognizes an answer about a list whose datagram has come before. By what it says, the answer to one transfer cannot be told from that to the next one: a vehicle
 * that is sent items before it asks for them asks for some alone, maybe for the first only. But each message that a vehicle sends has its next number.
 *
 * <p>A true answer that is taken for an earlier one, as exactly 256 messages lie between both, or as the vehicle does not count its messages, counts as one that was
 * lost on the way. Used by one thread.
 */
final class RepeatedAnswers {
    private static final long MOST_LATE_MS = 3_000; // later, the vehicle may have come to the same number again

    private final Map<Integer, Heard> heard = new HashMap<>(); // by their numbers

    /** An answer, and when it came. */
    private record Heard(MissionAck answer, long atMs) {}

    /** Whether this message is an answer that has come before. */
    boolean isRepeated(Object message, int number, long nowMs) {
        if (!(message instanceof MissionAck answer)) {
            return false;
        }
        Heard before = heard.put(number, new Heard(answer, nowMs));
        return before != null && before.answer.equals(answer) && nowMs - before.atMs < MOST_LATE_MS;
    }
}
