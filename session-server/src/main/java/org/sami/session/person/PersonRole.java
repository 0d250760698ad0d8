package org.sami.session.person;

import java.util.Collections;
import java.util.EnumSet;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import org.sami.spn.protocol.Decision;
import org.sami.spn.protocol.Ids;

/** What somebody is in a session; gives rights. Every role may stop the fleet. */
public enum PersonRole {
    /** Does everything. */
    OPERATOR(EnumSet.allOf(Right.class)),
    /** Drives boats, presses interrupts and answers questions about boats; starts nothing. */
    PILOT(EnumSet.of(Right.STOP, Right.ANSWER, Right.PRESS, Right.DRIVE)),
    /** Watches, and may stop the fleet. */
    OBSERVER(EnumSet.of(Right.STOP));

    private final Set<Right> rights;

    PersonRole(Set<Right> rights) {
        this.rights = Collections.unmodifiableSet(rights);
    }

    /** What it may do. */
    public Set<Right> rights() {
        return rights;
    }

    /** Its name in messages, files and commands. */
    public String word() {
        return name().toLowerCase(Locale.ROOT);
    }

    /** The role of a name; empty for none. */
    public static Optional<PersonRole> of(String word) {
        for (PersonRole role : values()) {
            if (role.word().equals(word.toLowerCase(Locale.ROOT))) {
                return Optional.of(role);
            }
        }
        return Optional.empty();
    }

    /** Whether a decision is this role's where a person has no list of types: a pilot's are those that the domain asks, and the choice of a press's boats. */
    boolean answers(Decision decision) {
        return switch (this) {
            case OPERATOR -> true;
            case PILOT -> decision.isInterruptChoice() || decision.mission() == Ids.NONE;
            case OBSERVER -> false;
        };
    }
}
