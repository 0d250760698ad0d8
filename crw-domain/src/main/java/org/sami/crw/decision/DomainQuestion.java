package org.sami.crw.decision;

import java.util.Arrays;
import java.util.Optional;

/** What the operator is asked outside of any plan: yes or no, about one boat or what one activation asks of several. */
public enum DomainQuestion {
    /** A boat's server has restarted: may the boat be moved again? */
    BOAT_RESTARTED("BoatRestarted", true),
    /** Another base wishes to command a boat: is it to have it? */
    COMMAND_ASKED("CommandAsked", true),
    /** Boats are sent far away or onto land: are they to go? */
    DOUBTFUL_WAY("DoubtfulWay", false),
    /** Boats are sent farther than their charge lasts: are they to go? */
    LONG_WAY("LongWay", true),
    /** A boat came back twice for a new battery and has visited nothing more: is it to go without coming home first? */
    FUTILE_WAY("FutileWay", true),
    /** The same of a boat that would have to be fetched. */
    ONE_WAY("OneWay", false);

    private final String kind;
    private final boolean simulatedAnswer;

    DomainQuestion(String kind, boolean simulatedAnswer) {
        this.kind = kind;
        this.simulatedAnswer = simulatedAnswer;
    }

    /** How decisions, answers files and journals name it; the type of its decision. */
    public String kind() {
        return kind;
    }

    /** What the simulated operator says where no answers file says otherwise. */
    public boolean simulatedAnswer() {
        return simulatedAnswer;
    }

    /** Whether it is asked about the ways of boats. */
    public boolean isAboutWays() {
        return this == DOUBTFUL_WAY || this == LONG_WAY || this == FUTILE_WAY || this == ONE_WAY;
    }

    /** The question of a kind. */
    public static Optional<DomainQuestion> of(String kind) {
        return Arrays.stream(values())
                .filter(question -> question.kind.equals(kind))
                .findFirst();
    }
}
