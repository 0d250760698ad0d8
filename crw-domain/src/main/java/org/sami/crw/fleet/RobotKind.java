package org.sami.crw.fleet;

import java.util.Optional;

/** The kind of robots that a domain commands, with the word for them in texts. */
public enum RobotKind {
    /** Boats on the water. */
    BOAT("boat"),
    /** Copters in the air. */
    COPTER("copter"),
    /** Boats and copters in one fleet; one robot of it is one of the two. */
    ROBOT("robot");

    /** What is said of robots of another kind than a session's; a text about copters keeps it as it is. */
    static final class OtherKind {
        static final String COPTER_AMONG_BOATS = "is a copter, and this session drives boats";
        static final String BOAT_AMONG_COPTERS = "is a boat, and this session flies copters";
    }

    /**
     * A boat, in texts in which its kind is the point, as beside a copter: no other word is put in its place by {@link #say}, in no domain. So a text names the
     * two kinds by these words and {@code copter}.
     */
    public static final String SURFACE_BOAT = "surface boat";

    private final String word;

    RobotKind(String word) {
        this.word = word;
    }

    /** The word for one of them, in texts and at the beginning of names. */
    public String word() {
        return word;
    }

    /**
     * The kind of a word.
     *
     * @throws IllegalArgumentException naming the word, where it is none
     */
    public static RobotKind of(String word) {
        for (RobotKind kind : values()) {
            if (kind.word.equals(word)) {
                return kind;
            }
        }
        throw new IllegalArgumentException("there are no robots of the kind '" + word + "'");
    }

    /**
     * What one robot of this kind is.
     *
     * @param flies whether it does; looked at only where both kinds are together
     */
    public RobotKind of(boolean flies) {
        return this == ROBOT ? flies ? COPTER : BOAT : this;
    }

    /**
     * Why a robot is none for plans that command this kind, as {@code is a boat, and this session flies copters}; empty where it is one.
     *
     * @param flies whether it does
     */
    public Optional<String> unfit(boolean flies) {
        return switch (this) {
            case ROBOT -> Optional.empty();
            case BOAT -> flies ? Optional.of(OtherKind.COPTER_AMONG_BOATS) : Optional.empty();
            case COPTER -> flies ? Optional.empty() : Optional.of(OtherKind.BOAT_AMONG_COPTERS);
        };
    }

    /** What a simulated robot of a name is: where both kinds are together, the names of copters begin with their word. */
    public RobotKind ofName(String name) {
        return of(name.startsWith(COPTER.word));
    }

    /** Says a text about boats of robots of this kind: by their word, and by what they do. Names and paths stay as they are. */
    public String say(String text) {
        return switch (this) {
            case BOAT -> text;
            case COPTER -> CopterWords.of(text);
            case ROBOT -> RobotWords.of(text);
        };
    }

    /** The name of a simulated one, counted from 0. */
    public String nameOf(int index) {
        return word + (index + 1);
    }
}
