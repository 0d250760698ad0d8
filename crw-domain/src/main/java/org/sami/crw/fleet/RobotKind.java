package org.sami.crw.fleet;

/** The kind of robots that a domain commands, with the word for them in texts. */
public enum RobotKind {
    /** Boats on the water. */
    BOAT("boat"),
    /** Copters in the air. */
    COPTER("copter"),
    /** Boats and copters in one fleet; one robot of it is one of the two. */
    ROBOT("robot");

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
