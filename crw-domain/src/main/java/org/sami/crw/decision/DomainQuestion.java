package org.sami.crw.decision;

import java.util.Arrays;
import java.util.Optional;

/** What the operator is asked outside of any plan: yes or no, about one boat. */
public enum DomainQuestion {
    /** A boat's server has started anew: may the boat be moved again? */
    BOAT_RESTARTED("BoatRestarted"),
    /** Another base wishes to command a boat: is it to have it? */
    COMMAND_ASKED("CommandAsked");

    private final String kind;

    DomainQuestion(String kind) {
        this.kind = kind;
    }

    /** How decisions, answers files and journals name it; the type of its decision. */
    public String kind() {
        return kind;
    }

    /** The question of a kind. */
    public static Optional<DomainQuestion> of(String kind) {
        return Arrays.stream(values())
                .filter(question -> question.kind.equals(kind))
                .findFirst();
    }
}
