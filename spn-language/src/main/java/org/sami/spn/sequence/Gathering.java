package org.sami.spn.sequence;

/** How a plan goes on where robots or tasks answer one by one. */
public enum Gathering {
    /** The transition fires once, when all who stand in its places have answered. */
    WAIT_FOR_ALL(Sequence.USUAL, "Waits for all", "Nobody goes on before all have answered; then all go on together."),
    /** Each goes on alone. */
    EACH("each-as-it-arrives", "Each goes on as it arrives", "Each goes on alone as soon as it has answered."),
    /** Each leaves the place when it has answered, and all go on together when nobody is left there. */
    EACH_THEN_TOGETHER(
            "each-then-together",
            "Each as it arrives, then all together",
            "Each leaves when it has answered; all go on when nobody is left behind, also when some have failed.");

    private final String id;
    private final String label;
    private final String help;

    Gathering(String id, String label, String help) {
        this.id = id;
        this.label = label;
        this.help = help;
    }

    /** The id of a sequence that goes on so. */
    public String id() {
        return id;
    }

    /** A few words for people. */
    public String label() {
        return label;
    }

    /** A sentence for the author. */
    public String help() {
        return help;
    }
}
