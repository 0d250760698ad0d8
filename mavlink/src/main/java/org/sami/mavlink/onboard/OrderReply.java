package org.sami.mavlink.onboard;

import java.util.Objects;

/**
 * What a vehicle answers to an order.
 *
 * @param words why it is refused, for people at the ground station; empty where it is carried out
 */
public record OrderReply(Result result, String words) {
    /** The results of the command protocol (MAV_RESULT) that a vehicle gives. */
    public enum Result {
        /** It is carried out. */
        ACCEPTED,
        /** Not now; later it may be. */
        TEMPORARILY_REJECTED,
        /** Not with these values. */
        DENIED,
        /** The vehicle has no such command. */
        UNSUPPORTED,
        /** It was tried and did not succeed. */
        FAILED
    }

    /** It is carried out. */
    public static final OrderReply ACCEPTED = new OrderReply(Result.ACCEPTED, "");

    /** An answer. */
    public OrderReply {
        Objects.requireNonNull(result, "result");
        Objects.requireNonNull(words, "words");
    }

    /** Not now. */
    public static OrderReply notNow(String why) {
        return new OrderReply(Result.TEMPORARILY_REJECTED, why);
    }

    /** Not with these values. */
    public static OrderReply denied(String why) {
        return new OrderReply(Result.DENIED, why);
    }

    /** The vehicle has no such command. */
    public static OrderReply unsupported(String why) {
        return new OrderReply(Result.UNSUPPORTED, why);
    }

    /** It was tried and did not succeed. */
    public static OrderReply failed(String why) {
        return new OrderReply(Result.FAILED, why);
    }

    /** Whether it is carried out. */
    public boolean isAccepted() {
        return result == Result.ACCEPTED;
    }
}
