package org.sami.crw.fleet;

/** The kind of robots that a domain commands, with the word for them in texts. */
public enum RobotKind {
    /** Boats on the water. */
    BOAT("boat"),
    /** Copters in the air. */
    COPTER("copter");

    /** Not within a name, an address or a path: boat-2, boat.local:5001 and /home/me/boats/x.log stay as they are. */
    private static final String BEFORE = "(?<![\\w./\\\\-])";

    private static final String AFTER = "(?=s?\\b(?![-/\\\\:]|\\.\\w))";

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

    /** Replaces boat, boats, Boat and Boats in a text by the word of this kind. */
    public String say(String text) {
        if (this == BOAT) {
            return text;
        }
        String capital = Character.toUpperCase(word.charAt(0)) + word.substring(1);
        return text.replaceAll(BEFORE + "boat" + AFTER, word).replaceAll(BEFORE + "Boat" + AFTER, capital);
    }

    /** The name of a simulated one, counted from 0. */
    public String nameOf(int index) {
        return word + (index + 1);
    }
}
