package org.sami.crw.handler.motion;

import java.util.Optional;
import org.sami.spn.value.BooleanValue;
import org.sami.spn.value.TextValue;
import org.sami.spn.value.Value;

/** What was answered to a question about a way. */
enum WayAnswer {
    /** The operator sends it. */
    YES(new BooleanValue(true), ""),
    /** The operator does not send it. */
    NO(new BooleanValue(false), WayQuestions.REJECTED_WAY),
    /** Nobody answered before its time was up. */
    NOBODY(new TextValue("nobody"), "nobody answered in time whether it is sent");

    private final Value remembered;
    private final String reason;

    WayAnswer(Value remembered, String reason) {
        this.remembered = remembered;
        this.reason = reason;
    }

    /** As a mission remembers it. */
    Value remembered() {
        return remembered;
    }

    /** Why a move is not made, in words; empty where it is. */
    String reason() {
        return reason;
    }

    /** What a mission remembers; empty for anything else. */
    static Optional<WayAnswer> of(Value remembered) {
        for (WayAnswer one : values()) {
            if (one.remembered.equals(remembered)) {
                return Optional.of(one);
            }
        }
        return Optional.empty();
    }
}
