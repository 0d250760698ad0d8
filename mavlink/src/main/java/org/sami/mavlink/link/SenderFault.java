package org.sami.mavlink.link;

/** What is wrong with how a vehicle speaks on a link. */
public enum SenderFault {
    /** Its messages have no place for all that is asked: it is not commanded. */
    FIRST_VERSION_ONLY(
            "speaks MAVLink 1 only; set the autopilot's port to MAVLink 2 (ArduPilot: SERIALn_PROTOCOL 2)", false),
    /** It may refuse whatever is not signed with its key; on its first port ArduPilot takes all. */
    KEY_IS_MISSING(
            "signs what it sends, and this base has no key: it may refuse all that it is sent. Bring its fleet's key here with"
                    + " \"crw keys import\", or give it one of yours over a cable with \"crw keys fleet --give\"",
            true);

    private final String words;
    private final boolean commanded;

    SenderFault(String words, boolean commanded) {
        this.words = words;
        this.commanded = commanded;
    }

    /** What it does, and what is to be done; to follow a vehicle's name. */
    public String words() {
        return words;
    }

    /** Whether a vehicle that speaks so is commanded all the same. */
    public boolean isCommanded() {
        return commanded;
    }
}
