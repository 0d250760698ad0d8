package org.sami.mavlink.link;

/** Why a message is refused where messages must be signed. */
public enum SignatureFault {
    /** It has no signature. */
    UNSIGNED("without a signature"),
    /** It was signed with another key, or changed on its way. */
    WRONG("with a wrong signature: another key, or changed on the way"),
    /** Its time is not later than that of a message before it. */
    REPLAYED("that came before already, or came late"),
    /** Its time is long past: it was recorded, or the sender's clock is wrong. */
    OLD("signed more than a minute ago: recorded, or the sender's clock is wrong");

    private final String words;

    SignatureFault(String words) {
        this.words = words;
    }

    /** Words for people that follow "3 messages". */
    public String words() {
        return words;
    }
}
